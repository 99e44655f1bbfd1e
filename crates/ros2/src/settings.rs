//! Settings of the node.

use std::net::Ipv4Addr;

use dobot_api::StationOptions;
use dobot_model::MountedTool;
use ros2_client::{NodeName, ServiceMapping};

/// Settings of the node.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The station of the arm.
    pub station: StationOptions,
    /// The DDS domain, 0 to 232: only programs of the same domain find each other.
    pub domain: u16,
    /// The namespace of topics, services and frames, as `/desk_3`; `/` means none.
    pub namespace: String,
    /// The addresses of this machine to use; 127.0.0.1 is this machine only.
    pub interfaces: Vec<Ipv4Addr>,
    /// The middleware of the other nodes.
    pub middleware: Middleware,
    /// The mounted tool, for the description.
    pub tool: Option<MountedTool>,
    /// The maximum deviation of a thinned trajectory, in degrees of all joints combined, unless the
    /// goal sets less and as far as the link can carry it.
    pub deviation_deg: f64,
}

/// The ROS 2 middleware of the other nodes, which determines the format of services.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Middleware {
    /// `rmw_fastrtps_cpp`, which most distributions use, and `rmw_connextdds`.
    #[default]
    FastDds,
    /// `rmw_cyclonedds_cpp`.
    CycloneDds,
}

impl Middleware {
    /// Parses a value of `RMW_IMPLEMENTATION`.
    ///
    /// # Errors
    ///
    /// [`UnknownMiddleware`] if it is not supported.
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

/// The error returned for an unsupported middleware.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the middleware is {found:?}; allowed are rmw_fastrtps_cpp, rmw_fastrtps_dynamic_cpp, rmw_connextdds and rmw_cyclonedds_cpp"
)]
pub struct UnknownMiddleware {
    found: String,
}

/// Checks that a namespace is valid in ROS 2, as `/desk_3`.
///
/// # Errors
///
/// [`BadNamespace`] if it is not.
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

/// The error returned for an invalid namespace.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "the namespace is {found:?}; allowed are / and names after slashes, as /desk_3, each with letters, digits and single underscores, beginning with a letter"
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
    fn a_namespace_is_distinguished_from_invalid_text() {
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
    fn an_unsupported_middleware_is_reported_with_the_supported_ones() {
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
        fn no_text_makes_the_check_of_a_namespace_panic(text in ".{0,20}") {
            let _ = check_namespace(&text);
            let _ = Middleware::named(&text);
        }
    }
}
