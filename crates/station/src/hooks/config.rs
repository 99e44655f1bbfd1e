//! The file of hooks.

use std::fmt;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::Duration;

use axum::http::Uri;
use serde::Deserialize;

use super::event::EventKind;

/// A webhook or a command, and the events that it receives.
#[derive(Clone, Debug)]
pub(crate) struct Hook {
    pub(super) on: Vec<EventKind>,
    pub(super) action: Action,
}

/// What is done on an event.
#[derive(Clone, Debug)]
pub(crate) enum Action {
    Web(WebHook),
    Command(Command),
}

/// A webhook.
#[derive(Clone)]
pub(crate) struct WebHook {
    /// Which certificates to trust over https; none over plain http.
    pub(super) tls: Option<Authorities>,
    pub(super) host: String,
    pub(super) port: u16,
    /// The host as in the header, with a port that is not the usual one.
    pub(super) authority: String,
    /// The path with the query.
    pub(super) path: String,
    pub(super) secret: String,
}

/// The certificates of trusted authorities, a PEM file.
#[cfg(feature = "full")]
#[derive(Clone)]
pub(super) struct Authorities(pub(super) PathBuf);

/// Nothing to trust: this build has no TLS.
#[cfg(not(feature = "full"))]
#[derive(Clone)]
pub(super) enum Authorities {}

/// A command, which runs without a shell.
#[derive(Clone, Debug)]
pub(crate) struct Command {
    pub(super) program: String,
    pub(super) arguments: Vec<String>,
    pub(super) limit: Duration,
}

/// The error returned for an unusable file of hooks.
#[derive(Debug, thiserror::Error)]
#[error("the hooks {file} are invalid: {why}")]
pub struct HooksError {
    file: String,
    why: String,
}

impl fmt::Debug for WebHook {
    /// Leaves the secret out, and the path, which may contain another one.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = f.debug_struct("WebHook");
        shown.field("authority", &self.authority);
        shown.finish_non_exhaustive()
    }
}

impl Hook {
    /// Returns what it is, for messages; without secrets.
    pub(super) fn label(&self) -> String {
        match &self.action {
            Action::Web(web) => format!("the webhook at {}", web.authority),
            Action::Command(command) => format!("the command {}", command.program),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HooksFile {
    #[serde(default)]
    hook: Vec<HookText>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct HookText {
    on: Vec<EventKind>,
    url: Option<String>,
    secret: Option<String>,
    ca: Option<PathBuf>,
    command: Option<Vec<String>>,
    limit_s: Option<u64>,
}

/// Reads the hooks of a file; none if it does not exist.
///
/// # Errors
///
/// [`HooksError`]: it cannot be read, or says something that is not allowed.
pub(crate) fn read(file: &Path) -> Result<Vec<Hook>, HooksError> {
    let error = |why: String| HooksError {
        file: file.display().to_string(),
        why,
    };
    match std::fs::read_to_string(file) {
        Err(missing) if missing.kind() == ErrorKind::NotFound => Ok(Vec::new()),
        Err(unreadable) => Err(error(unreadable.to_string())),
        Ok(text) => parse(&text).map_err(error),
    }
}

fn parse(text: &str) -> Result<Vec<Hook>, String> {
    let file: HooksFile = toml::from_str(text).map_err(|error| error.to_string())?;
    let hooks = file.hook.into_iter().enumerate();
    let hook = |(index, text)| hook(text).map_err(|why| format!("hook {}: {why}", index + 1));
    hooks.map(hook).collect()
}

fn hook(text: HookText) -> Result<Hook, String> {
    if text.on.is_empty() {
        return Err("`on` is empty; allowed are job-done, needs-person and link-lost".into());
    }
    let action = match (text.url, text.command) {
        (Some(url), None) if text.limit_s.is_none() => {
            Action::Web(web(&url, text.secret, text.ca)?)
        }
        (None, Some(command)) if text.secret.is_none() && text.ca.is_none() => {
            Action::Command(self::command(command, text.limit_s)?)
        }
        _ => {
            return Err(
                "give either `url` with `secret`, or `command`, which may have `limit_s`".into(),
            );
        }
    };
    Ok(Hook {
        on: text.on,
        action,
    })
}

fn web(url: &str, secret: Option<String>, ca: Option<PathBuf>) -> Result<WebHook, String> {
    // The address may contain a secret: it is not repeated.
    let uri: Uri = url
        .parse()
        .map_err(|error| format!("`url` is no address: {error}"))?;
    let is_encrypted = is_encrypted(&uri)?;
    let authority = uri.authority().filter(|name| !name.as_str().contains('@'));
    let authority = authority.ok_or("`url` has no host, or a user name")?;
    let secret = long_enough(secret)?;
    let tls = tls(is_encrypted, ca)?;
    let host = authority.host();
    let path = uri.path_and_query().map_or("/", |path| path.as_str());
    Ok(WebHook {
        tls,
        host: host
            .trim_start_matches('[')
            .trim_end_matches(']')
            .to_owned(),
        port: authority
            .port_u16()
            .unwrap_or(if is_encrypted { 443 } else { 80 }),
        authority: authority.to_string(),
        path: path.to_owned(),
        secret,
    })
}

fn is_encrypted(uri: &Uri) -> Result<bool, String> {
    match uri.scheme_str() {
        Some("http") => Ok(false),
        Some("https") => Ok(true),
        _ => Err("`url` begins with neither http:// nor https://".into()),
    }
}

fn tls(is_encrypted: bool, ca: Option<PathBuf>) -> Result<Option<Authorities>, String> {
    match (is_encrypted, ca) {
        (true, ca) => authorities(ca).map(Some),
        (false, None) => Ok(None),
        (false, Some(_)) => Err("`ca` is only for https".into()),
    }
}

fn long_enough(secret: Option<String>) -> Result<String, String> {
    let secret = secret.filter(|secret| secret.chars().count() >= SHORTEST_SECRET);
    secret.ok_or_else(|| {
        format!("`secret` has fewer than {SHORTEST_SECRET} characters; it signs each event")
    })
}

/// Returns the given authorities, or those that the system trusts.
#[cfg(feature = "full")]
fn authorities(given: Option<PathBuf>) -> Result<Authorities, String> {
    let mut known = SYSTEM_AUTHORITIES.iter().map(PathBuf::from);
    let file = given.or_else(|| known.find(|file| file.is_file()));
    file.map(Authorities)
        .ok_or_else(|| "this system has no known file of authorities; give one with `ca`".into())
}

#[cfg(not(feature = "full"))]
fn authorities(_: Option<PathBuf>) -> Result<Authorities, String> {
    let part = dobot_api::NotBuilt("TLS");
    let hint = dobot_api::NotBuilt::HINT;
    Err(format!("`url` is encrypted, and {part}; {hint}"))
}

fn command(words: Vec<String>, limit_s: Option<u64>) -> Result<Command, String> {
    let limit_s = limit_s.unwrap_or(30);
    if !(1..=LONGEST_S).contains(&limit_s) {
        return Err(format!(
            "`limit_s` is {limit_s}; allowed are 1 to {LONGEST_S}"
        ));
    }
    let mut words = words.into_iter();
    let program = words.next().filter(|program| !program.is_empty());
    Ok(Command {
        program: program.ok_or("`command` is empty; it is a list: program and arguments")?,
        arguments: words.collect(),
        limit: Duration::from_secs(limit_s),
    })
}

#[cfg(feature = "full")]
/// Where systems keep the certificates of the authorities that they trust.
const SYSTEM_AUTHORITIES: [&str; 3] = [
    "/etc/ssl/certs/ca-certificates.crt",
    "/etc/pki/tls/certs/ca-bundle.crt",
    "/etc/ssl/cert.pem",
];
const SHORTEST_SECRET: usize = 16;
const LONGEST_S: u64 = 600;

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a failing test may panic")]
mod tests {
    use super::*;

    #[test]
    fn a_file_lists_webhooks_and_commands() {
        let hooks = parse(
            r#"
            [[hook]]
            on = ["job-done", "link-lost"]
            url = "http://example.org:8080/dobot?room=3"
            secret = "0123456789abcdef"

            [[hook]]
            on = ["needs-person"]
            command = ["notify-send", "Dobot"]
            limit_s = 5
            "#,
        )
        .unwrap();
        let [web, command] = &hooks[..] else {
            panic!("{hooks:?}")
        };
        assert_eq!(web.on, [EventKind::JobDone, EventKind::LinkLost]);
        assert_eq!(web.label(), "the webhook at example.org:8080");
        assert!(!format!("{web:?}").contains("0123456789abcdef"));
        assert_eq!(command.label(), "the command notify-send");
    }

    #[test]
    fn what_is_wrong_is_named_with_what_is_allowed() {
        for (text, part) in [
            ("on = []\nurl = \"http://a/\"", "`on` is empty"),
            ("on = [\"job-over\"]\nurl = \"http://a/\"", "needs-person"),
            ("on = [\"job-done\"]", "either `url`"),
            ("on = [\"job-done\"]\nurl = \"http://a/\"", "`secret`"),
            (
                "on = [\"job-done\"]\nurl = \"http://a/\"\nsecret = \"short\"",
                "16",
            ),
            (
                "on = [\"job-done\"]\nurl = \"ftp://a/\"\nsecret = \"0123456789abcdef\"",
                "https://",
            ),
            (
                "on = [\"job-done\"]\nurl = \"http://u:p@a/\"\nsecret = \"0123456789abcdef\"",
                "user name",
            ),
            ("on = [\"job-done\"]\ncommand = []", "list"),
            ("on = [\"job-done\"]\ncommand = \"rm -rf /\"", "sequence"),
            (
                "on = [\"job-done\"]\ncommand = [\"a\"]\nlimit_s = 0",
                "1 to 600",
            ),
            (
                "on = [\"job-done\"]\ncommand = [\"a\"]\nshell = true",
                "shell",
            ),
            (
                "on = [\"job-done\"]\ncommand = [\"a\"]\nurl = \"http://a/\"",
                "either",
            ),
        ] {
            let error = parse(&format!("[[hook]]\n{text}\n")).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }

    #[cfg(not(feature = "full"))]
    #[test]
    fn https_without_tls_is_refused_at_the_start() {
        let text =
            "[[hook]]\non = [\"job-done\"]\nurl = \"https://a/\"\nsecret = \"0123456789abcdef\"";
        let error = parse(text).unwrap_err();
        assert!(error.contains("TLS"), "{error}");
    }

    #[test]
    fn a_station_without_the_file_has_no_hooks() {
        let folder = tempfile::tempdir().unwrap();
        assert!(read(&folder.path().join("hooks.toml")).unwrap().is_empty());
    }
}
