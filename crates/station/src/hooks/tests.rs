//! Hooks with real connections and processes.

#![expect(clippy::unwrap_used, reason = "a failing test may panic")]

use dobot_api::{JobPhase, JobView};
use tokio::io::{AsyncRead, AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpListener;

use super::config::WebHook;
use super::*;
use crate::hooks::event::EventKind;
use crate::hooks::sign::signature;
use crate::sample::{job, notice};

const SECRET: &str = "0123456789abcdef";

fn done() -> Event {
    let news = News::Job {
        job: 7,
        phase: JobPhase::Done,
    };
    event(
        &notice(1, news, "job 7 is done"),
        Some(job(7)),
        "http://desk",
    )
    .unwrap()
}

/// Reads a webhook with this address and further lines from a file.
fn webhook(url: &str, lines: &str) -> WebHook {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("hooks.toml");
    let text =
        format!("[[hook]]\non = [\"job-done\"]\nurl = \"{url}\"\nsecret = \"{SECRET}\"\n{lines}");
    std::fs::write(&file, &text).unwrap();
    let mut hooks = read(&file).unwrap();
    let Action::Web(hook) = hooks.remove(0).action else {
        panic!("{text}")
    };
    hook
}

/// Receives a request up to the end of its body.
async fn receive(stream: &mut (impl AsyncRead + Unpin), body: &[u8]) -> String {
    let mut request = Vec::new();
    while !request.ends_with(body) {
        assert!(stream.read_buf(&mut request).await.unwrap() > 0);
    }
    String::from_utf8(request).unwrap()
}

/// A webhook at a server that answers with these statuses, one after the other; none closes the
/// connection. Returns the requests.
async fn requests_at(statuses: &[Option<u16>], event: &Event) -> (Vec<String>, Result<(), String>) {
    let server = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let address = server.local_addr().unwrap();
    let hook = webhook(&format!("http://{address}/a?b=c"), "");
    let serve = async {
        let mut requests = Vec::new();
        for status in statuses {
            let (mut stream, _) = server.accept().await.unwrap();
            requests.push(receive(&mut stream, &event.body).await);
            if let Some(status) = status {
                let answer = format!("HTTP/1.1 {status} X\r\nContent-Length: 0\r\n\r\n");
                stream.write_all(answer.as_bytes()).await.unwrap();
            }
        }
        requests
    };
    let at_once = vec![Duration::ZERO; 3];
    tokio::join!(serve, web::send(&hook, event, &at_once))
}

#[tokio::test]
async fn a_webhook_gets_the_event_with_a_signature_over_time_and_body() {
    let event = done();
    let (requests, sent) = requests_at(&[Some(204)], &event).await;
    sent.unwrap();
    let (head, body) = requests[0].split_once("\r\n\r\n").unwrap();
    assert!(head.starts_with("POST /a?b=c HTTP/1.0\r\n"), "{head}");
    let header = |name: &str| {
        let mut lines = head.lines();
        lines
            .find_map(|line| line.strip_prefix(name))
            .unwrap()
            .to_owned()
    };
    let time = header("Dobot-Timestamp: ");
    let expected = signature(SECRET, &time, body.as_bytes());
    assert_eq!(header("Dobot-Signature: "), format!("sha256={expected}"));
    assert_eq!(header("Dobot-Event: "), "job-done");
    let body: serde_json::Value = serde_json::from_str(body).unwrap();
    assert_eq!(body["event"], "job-done");
    assert_eq!(body["id"], header("Dobot-Delivery: "));
    assert_eq!(body["job"]["job"], 7);
    assert_eq!(body["station"], "http://desk");
}

#[tokio::test]
async fn a_webhook_that_fails_gets_the_same_event_again() {
    let event = done();
    let (requests, sent) = requests_at(&[Some(500), None, Some(429), Some(200)], &event).await;
    sent.unwrap();
    assert_eq!(requests.len(), 4);
    assert!(requests.iter().all(|request| request.contains(&event.id)));
}

#[tokio::test]
async fn after_the_last_attempt_or_a_refusal_the_reason_is_reported() {
    let (_, sent) = requests_at(&[Some(503); 4], &done()).await;
    let why = sent.unwrap_err();
    assert!(why.contains("4 times") && why.contains("503"), "{why}");
    let (requests, sent) = requests_at(&[Some(401)], &done()).await;
    assert_eq!(requests.len(), 1);
    assert!(sent.unwrap_err().contains("401"));
}

#[cfg(feature = "full")]
mod encrypted {
    use std::net::Ipv4Addr;
    use std::path::Path;

    use super::*;
    use crate::http::Certificate;

    /// A self-signed certificate, kept in this folder.
    fn certificate(folder: &Path) -> Certificate {
        Certificate::own(folder, &[], Ipv4Addr::LOCALHOST.into()).unwrap()
    }

    /// Sends an event to a server with this certificate, by a webhook that trusts the certificate
    /// in a folder. Returns the request if one arrives.
    async fn request_at(
        served: &Certificate,
        trusted: &Path,
    ) -> (Option<String>, Result<(), String>) {
        let server = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let url = format!("https://{}/", server.local_addr().unwrap());
        let ca = format!("ca = {:?}\n", trusted.join("certificate.pem"));
        let (hook, event) = (webhook(&url, &ca), done());
        let serve = async {
            let stream = server.accept().await.unwrap().0;
            let mut stream = served.acceptor.accept(stream).await.ok()?;
            let request = receive(&mut stream, &event.body).await;
            let answer = b"HTTP/1.1 204 No Content\r\n\r\n";
            stream.write_all(answer).await.unwrap();
            Some(request)
        };
        tokio::join!(serve, web::send(&hook, &event, &[]))
    }

    #[tokio::test]
    async fn a_webhook_over_https_reaches_a_server_whose_certificate_it_trusts() {
        let folder = tempfile::tempdir().unwrap();
        let (request, sent) = request_at(&certificate(folder.path()), folder.path()).await;
        sent.unwrap();
        assert!(request.unwrap().contains("Dobot-Signature: sha256="));
    }

    #[tokio::test]
    async fn a_webhook_over_https_sends_nothing_to_a_server_with_another_certificate() {
        let [served, trusted] = [(); 2].map(|()| tempfile::tempdir().unwrap());
        certificate(trusted.path());
        let (request, sent) = request_at(&certificate(served.path()), trusted.path()).await;
        assert_eq!(request, None);
        let why = sent.unwrap_err();
        assert!(why.contains("cannot connect"), "{why}");
    }
}

#[test]
fn a_pen_change_needs_a_person_and_a_pause_by_a_person_does_not() {
    let paused = |waits_for_person| {
        let news = News::Job {
            job: 7,
            phase: JobPhase::Paused,
        };
        let view = JobView {
            waits_for_person,
            ..job(7)
        };
        event(&notice(1, news, "pen 2"), Some(view), "http://desk").map(|event| event.kind)
    };
    assert_eq!(paused(true), Some(EventKind::NeedsPerson));
    assert_eq!(paused(false), None);
    let kind = |news| event(&notice(1, news, ""), None, "").map(|event| event.kind);
    assert_eq!(kind(News::LinkLost), Some(EventKind::LinkLost));
    assert_eq!(kind(News::LinkUp), None);
    for phase in [JobPhase::Stopped, JobPhase::Failed] {
        assert_eq!(kind(News::Job { job: 7, phase }), Some(EventKind::JobDone));
    }
}

#[cfg(unix)]
mod commands {
    use std::path::Path;

    use super::*;

    /// Runs a command with these words; whether it is done.
    async fn ran(words: &[&str], limit_s: u64) -> Result<(), String> {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("hooks.toml");
        let text =
            format!("[[hook]]\non = [\"job-done\"]\ncommand = {words:?}\nlimit_s = {limit_s}\n");
        std::fs::write(&file, text).unwrap();
        let hooks = read(&file).unwrap();
        let Action::Command(command) = hooks[0].action.clone() else {
            panic!("{hooks:?}")
        };
        command::run(command, done().body).await
    }

    fn contents(file: &Path) -> String {
        std::fs::read_to_string(file).unwrap()
    }

    #[tokio::test]
    async fn a_command_reads_the_event_and_no_shell_reads_its_arguments() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out $(touch x); y");
        ran(&["cp", "/dev/stdin", out.to_str().unwrap()], 30)
            .await
            .unwrap();
        let event: serde_json::Value = serde_json::from_str(&contents(&out)).unwrap();
        assert_eq!(event["event"], "job-done");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[tokio::test]
    async fn a_command_that_fails_or_does_not_exist_is_reported() {
        assert!(ran(&["false"], 30).await.unwrap_err().contains("failed"));
        let missing = ran(&["/nowhere/at/all"], 30).await;
        assert!(missing.unwrap_err().contains("cannot be started"));
    }

    #[tokio::test]
    async fn a_command_that_takes_too_long_is_ended_with_all_that_it_started() {
        let folder = tempfile::tempdir().unwrap();
        let pid = folder.path().join("pid");
        let script = format!("sleep 600 & echo $! > '{}'; wait", pid.display());
        let why = ran(&["sh", "-c", &script], 1).await.unwrap_err();
        assert!(why.contains("longer than 1 s"), "{why}");
        let pid = contents(&pid).trim().parse().ok();
        let pid = pid.and_then(rustix::process::Pid::from_raw).unwrap();
        let state = || std::fs::read_to_string(format!("/proc/{}/stat", pid.as_raw_nonzero()));
        // Killed: gone, or not yet buried.
        while state().is_ok_and(|stat| !stat.contains(") Z")) {
            assert!(rustix::process::test_kill_process(pid).is_ok());
            tokio::task::yield_now().await;
        }
    }
}

#[tokio::test]
async fn a_hook_receives_a_notice_in_a_thread_of_its_own() {
    let server = TcpListener::bind("127.0.0.1:0").await.unwrap();
    let url = format!("http://{}/", server.local_addr().unwrap());
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("hooks.toml");
    let text = format!("[[hook]]\non = [\"link-lost\"]\nurl = \"{url}\"\nsecret = \"{SECRET}\"\n");
    std::fs::write(&file, text).unwrap();
    let rules = dobot_host::Rules::of(&dobot_safety::Policy::default());
    let (handle, ends) = StationHandle::new(crate::sample::state(0.0), rules);
    start(read(&file).unwrap(), handle, "http://desk".into()).unwrap();
    for news in [News::LinkUp, News::LinkLost] {
        ends.publish_notice(notice(1, news, "the link to the arm was lost"));
    }
    let (mut stream, _) = server.accept().await.unwrap();
    let mut request = Vec::new();
    while !String::from_utf8_lossy(&request).contains("Dobot-Event: link-lost") {
        assert!(stream.read_buf(&mut request).await.unwrap() > 0);
    }
    drop(ends);
}
