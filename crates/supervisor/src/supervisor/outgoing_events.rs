//! Outgoing events for observers and requesters.

use std::collections::VecDeque;
use std::time::Duration;

use dobot_api::{ClientId, News, Notice, Reply};
use dobot_wire::Status;

use crate::refusal::Refusal;

/// Notices, statuses and answers until they are polled.
#[derive(Debug)]
pub(super) struct OutgoingEvents {
    notices: VecDeque<Notice>,
    notice_count: u64,
    /// Statuses for raw programs, which treat each one as a permit.
    statuses: VecDeque<Status>,
    /// Answers to requests that took time, with the requester.
    answers: VecDeque<(ClientId, Result<Reply, Refusal>)>,
    /// Whether the state has changed for observers.
    changed: bool,
}

impl OutgoingEvents {
    /// Starts as changed, so that the first state is published.
    pub(super) const fn new() -> Self {
        Self {
            notices: VecDeque::new(),
            notice_count: 0,
            statuses: VecDeque::new(),
            answers: VecDeque::new(),
            changed: true,
        }
    }

    pub(super) fn notify(&mut self, now: Duration, news: News, text: String) {
        self.notice_count += 1;
        self.changed = true;
        self.notices.push_back(Notice {
            number: self.notice_count,
            at_s: now.as_secs_f64(),
            news,
            text,
        });
    }

    pub(super) fn pass_on(&mut self, status: Status) {
        self.statuses.push_back(status);
    }

    pub(super) fn answer(&mut self, client: ClientId, answer: Result<Reply, Refusal>) {
        self.answers.push_back((client, answer));
    }

    pub(super) const fn note_change(&mut self) {
        self.changed = true;
    }

    pub(super) fn poll_notice(&mut self) -> Option<Notice> {
        self.notices.pop_front()
    }

    pub(super) fn poll_status(&mut self) -> Option<Status> {
        self.statuses.pop_front()
    }

    pub(super) fn poll_answer(&mut self) -> Option<(ClientId, Result<Reply, Refusal>)> {
        self.answers.pop_front()
    }

    pub(super) fn poll_changed(&mut self) -> bool {
        std::mem::take(&mut self.changed)
    }
}
