//! How the arm appears in ROS 2.

use std::net::Ipv4Addr;

use dobot_api::StationOptions;
use dobot_model::MountedTool;
use ros2_client::{NodeName, ServiceMapping};

/// How the arm appears in ROS 2.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Which station it is that of.
    pub station: StationOptions,
    /// The domain of DDS, 0 to 232: only programs of the same one find each other.
    pub domain: u16,
    /// Before the names of topics, services and frames, as `/desk_3`; `/` is none.
    pub namespace: String,
    /// The addresses of this machine under which it takes part; 127.0.0.1 is this machine alone.
    pub interfaces: Vec<Ipv4Addr>,
    /// How services travel.
    pub middleware: Middleware,
    /// What is mounted, for the description.
    pub tool: Option<MountedTool>,
    /// How far a thinned trajectory may be from the one that was wanted, in degrees of all joints together, unless the goal
    /// says less and as far as the link carries it.
    pub deviation_deg: f64,
}

/// Which implementation of ROS 2 the others use: services travel differently.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Middleware {
    /// `rmw_fastrtps_cpp`, which most distributions use, and `rmw_connextdds`.
    #[default]
    FastDds,
    /// `rmw_cyclonedds_cpp`.
    CycloneDds,
}

impl Middleware {
    /// That of a value of `RMW_IMPLEMENTATION`.
    ///
    /// # Errors
    ///
    /// [`UnknownMiddleware`] for one that is not spoken here.
    pub fn named(name: &str) -> Result<Self, UnknownMiddleware> {
        match name {
            "rmw_fastrtps_cpp" | "rmw_fastrtps_dynamic_cpp" | "rmw_connextdds" => Ok(Self::FastDds),
            "rmw_cyclonedds_cpp" => Ok(Self::CycloneDds),
            _ => Err(UnknownMiddleware {
                found: name.to_owned(),
            }),
        }
    }

    pub(crate) const fn mapping(self) -> ServiceMapping {
        match self {
            Self::FastDds => ServiceMapping::Enhanced,
            Self::CycloneDds => ServiceMapping::Cyclone,
        }
    }
}

/// A middleware that is not spoken here.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the middleware is {found:?}; allowed are rmw_fastrtps_cpp, rmw_fastrtps_dynamic_cpp, rmw_connextdds and rmw_cyclonedds_cpp"
)]
pub struct UnknownMiddleware {
    found: String,
}

/// Whether a namespace is one of ROS 2, as `/desk_3`.
///
/// # Errors
///
/// [`BadNamespace`] where it is not.
pub fn check_namespace(namespace: &str) -> Result<(), BadNamespace> {
    let parts = namespace.strip_prefix('/').map(|path| path.split('/'));
    let is_name = |name: &str| {
        name.starts_with(|character: char| character.is_ascii_alphabetic())
            && name
                .chars()
                .all(|character| character.is_ascii_alphanumeric() || character == '_')
            && !name.contains("__")
    };
    let is_good = namespace == "/"
        || parts.is_some_and(|mut parts| parts.all(is_name))
            && NodeName::new(namespace, NODE).is_ok();
    if is_good {
        return Ok(());
    }
    Err(BadNamespace {
        found: namespace.to_owned(),
    })
}

/// A text that is no namespace.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the namespace is {found:?}; allowed is / and names behind slashes, as /desk_3: each of letters, digits and single underscores, and a letter first"
)]
pub struct BadNamespace {
    found: String,
}

/// The node's name.
pub(crate) const NODE: &str = "dobot";

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_namespace_is_told_apart_from_what_is_none() {
        for good in ["/", "/desk_3", "/room/desk_3"] {
            assert_eq!(check_namespace(good), Ok(()), "{good}");
        }
        for bad in [
            "", "desk", "/3", "/desk-3", "/desk/", "//desk", "/a__b", "/_a", "/a b",
        ] {
            assert!(check_namespace(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_middleware_that_is_not_spoken_is_told_with_those_that_are() {
        assert_eq!(
            Middleware::named("rmw_fastrtps_cpp"),
            Ok(Middleware::FastDds)
        );
        assert_eq!(
            Middleware::named("rmw_cyclonedds_cpp"),
            Ok(Middleware::CycloneDds)
        );
        let error = Middleware::named("rmw_zenoh_cpp").unwrap_err().to_string();
        assert!(error.contains("rmw_cyclonedds_cpp"), "{error}");
    }

    proptest! {
        #[test]
        fn no_text_makes_the_look_at_a_namespace_panic(text in ".{0,20}") {
            let _ = check_namespace(&text);
            let _ = Middleware::named(&text);
        }
    }
}
