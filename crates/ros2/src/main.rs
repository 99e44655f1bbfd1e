//! `dobot-ros2`: the arm of a station in ROS 2.

use std::net::Ipv4Addr;
use std::process::ExitCode;

use anyhow::{Context, anyhow};
use clap::Parser;
use dobot_api::StationOptions;
use dobot_model::ToolOptions;
use dobot_ros2::{Middleware, Settings, check_namespace, run};
use dobot_safety::Policy;
use tokio::sync::watch;

/// Add the arm of a station to ROS 2, without a ROS installation
///
/// Publishes joint states, transforms, diagnostics and the robot's description, and accepts
/// targets, jogs, a stop, and trajectories. It is a client of the station: all of the station's
/// rules apply.
#[derive(Debug, Parser)]
#[command(
    name = "dobot-ros2",
    version,
    max_term_width = 100,
    after_help = "\
Examples:
  dobot up                              start the station first, in another terminal
  dobot-ros2                            for programs on this machine
  dobot-ros2 --interface 192.168.1.5    also for that network: anyone in it may then move the arm
  dobot-ros2 --domain 7 --namespace /desk_3
  RMW_IMPLEMENTATION=rmw_cyclonedds_cpp dobot-ros2

DDS has no access control. With a token of the role `watch` (`dobot token`) the node only observes."
)]
struct Args {
    #[command(flatten)]
    station: StationOptions,
    /// DDS domain, 0 to 232 [default: `ROS_DOMAIN_ID`, or 0]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(0..=232))]
    domain: Option<u16>,
    /// Namespace of topics, services and frames, as `/desk_3`
    #[arg(long, value_name = "NAME", default_value = "/", value_parser = namespace)]
    namespace: String,
    /// Address of this machine to use; may be given more than once
    #[arg(
        long = "interface",
        value_name = "ADDRESS",
        default_value = "127.0.0.1"
    )]
    interfaces: Vec<Ipv4Addr>,
    #[command(flatten)]
    tool: ToolOptions,
    /// Maximum deviation of a thinned trajectory, in degrees, as far as the link can carry it
    #[arg(long, value_name = "DEGREES", default_value_t = 1.0, value_parser = deviation)]
    deviation: f64,
}

fn main() -> ExitCode {
    match start(Args::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn start(args: Args) -> anyhow::Result<()> {
    let settings = args.settings()?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("cannot start threads")?;
    let done = runtime.block_on(async {
        let (end, ending) = watch::channel(false);
        let interrupted = interrupt();
        tokio::spawn(async move {
            interrupted.await;
            end.send_replace(true);
        });
        run(settings, ending).await
    });
    runtime.shutdown_background();
    Ok(done?)
}

impl Args {
    fn settings(self) -> anyhow::Result<Settings> {
        let lengths = Policy::default().tool_length;
        let tool = self.tool.mounted(|tool| lengths.of(tool))?;
        let domain = match (self.domain, variable("ROS_DOMAIN_ID")) {
            (Some(domain), _) => domain,
            (None, None) => 0,
            (None, Some(text)) => domain(&text)?,
        };
        let middleware = variable("RMW_IMPLEMENTATION");
        let middleware = middleware
            .map(|middleware| Middleware::named(&middleware))
            .transpose();
        Ok(Settings {
            station: self.station,
            domain,
            namespace: self.namespace,
            interfaces: self.interfaces,
            middleware: middleware
                .context("RMW_IMPLEMENTATION")?
                .unwrap_or_default(),
            tool,
            deviation_deg: self.deviation,
        })
    }
}

fn namespace(text: &str) -> Result<String, String> {
    check_namespace(text).map_err(|error| error.to_string())?;
    Ok(text.to_owned())
}

fn domain(text: &str) -> anyhow::Result<u16> {
    let found = text.parse().ok().filter(|domain| *domain <= 232);
    found.ok_or_else(|| anyhow!("ROS_DOMAIN_ID is {text:?}; allowed are 0 to 232"))
}

fn deviation(text: &str) -> Result<f64, String> {
    let found = text
        .parse()
        .ok()
        .filter(|degrees| (0.0..=90.0).contains(degrees));
    found.ok_or_else(|| "allowed are 0 to 90 degrees".to_owned())
}

/// Returns the value of a non-empty environment variable.
fn variable(name: &str) -> Option<String> {
    std::env::var(name).ok().filter(|text| !text.is_empty())
}

/// Waits for Ctrl-C, or a termination signal.
#[cfg(unix)]
fn interrupt() -> impl Future<Output = ()> {
    use tokio::signal::unix::{SignalKind, signal};

    let signals = [SignalKind::interrupt(), SignalKind::terminate()].map(signal);
    async move {
        let [Ok(mut interrupt), Ok(mut terminate)] = signals else {
            return std::future::pending().await;
        };
        tokio::select! {
            _ = interrupt.recv() => {}
            _ = terminate.recv() => {}
        }
    }
}

/// Waits for Ctrl-C.
#[cfg(not(unix))]
async fn interrupt() {
    if tokio::signal::ctrl_c().await.is_err() {
        std::future::pending::<()>().await;
    }
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        use clap::CommandFactory;
        Args::command().debug_assert();
    }

    #[test]
    fn an_invalid_option_is_refused_with_what_is_allowed() {
        for (words, expected) in [
            (vec!["--domain", "233"], "0..=232"),
            (vec!["--namespace", "desk-3"], "/desk_3"),
            (vec!["--interface", "eth0"], "ADDRESS"),
            (vec!["--deviation", "NaN"], "0 to 90"),
        ] {
            let words = ["dobot-ros2"].into_iter().chain(words);
            let error = Args::try_parse_from(words).unwrap_err().to_string();
            assert!(error.contains(expected), "{error}");
        }
        assert!(domain("300").is_err() && domain("x").is_err());
    }
}
