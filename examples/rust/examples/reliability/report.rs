//! The generated document.

use std::fmt::{Display, Write};

use crate::cases::spread::Spread;
use crate::cases::watchdogs::Guarded;
use crate::cases::{
    cables, carries, clients, disks, floods, fuzz, kills, lines, long_lines, sessions,
    standing_laser, stops, watchdogs,
};

/// The document, and the errors found.
#[derive(Debug, Default)]
pub(crate) struct Report {
    /// Markdown.
    pub text: String,
    /// The errors, one per line.
    pub wrong: Vec<String>,
}

impl Report {
    /// Writes all sections, with the number of cases divided by `fewer`.
    pub(crate) fn all(&mut self, fewer: u64) {
        self.line(HEAD);
        self.kills(1_000 / fewer);
        self.watchdogs(100_u64.div_ceil(fewer));
        self.cables(200 / fewer);
        self.lines(200 / fewer);
        self.carries(10_000 / fewer);
        self.clients(400 / fewer);
        self.floods(100_u64.div_ceil(fewer));
        self.disks(400 / fewer);
        self.stops(1_440 / fewer);
        self.long_lines(40_u64.div_ceil(fewer));
        self.standing_laser(60_u64.div_ceil(fewer));
        self.sessions(1_000 / fewer);
        self.line(TAIL);
        self.fuzz(200 / fewer);
        self.work();
    }

    fn kills(&mut self, kills: u64) {
        let result = kills::run(usize::try_from(kills).unwrap_or(usize::MAX));
        self.line(KILLS);
        self.table(["", ""], &[]);
        self.row("kills", result.times);
        self.row("while a job had the arm", result.at_work);
        self.row("while the laser burned", result.burning);
        self.row("jobs, all completed", result.jobs);
        self.row("**commands lost**", result.lost);
        self.row("**commands repeated**", result.repeated);
        self.row("positions that a person had to give", result.unclear);
        self.row(
            "first packet after the start not laser off",
            result.not_off_first,
        );
        self.row(
            "laser on after the arm had come to rest",
            result.burnt_at_rest,
        );
        self.line("");
        self.times("From the start of the new station to the end of the light, if it burned");
        self.row("light", &result.off_after_s);
        self.wrong(result.wrong);
    }

    fn watchdogs(&mut self, times: u64) {
        let all = watchdogs::run(times);
        let sum: usize = all.iter().map(|row| row.times).sum();
        self.line(WATCHDOGS);
        self.line(&format!("{sum} stations in all.\n"));
        self.table(
            ["the station is", "while the arm does"],
            &[
                "first packet, s",
                "arm at rest, s",
                "distance, mm",
                "joint motion, degrees",
                "end of the light, s",
                "light on a spot, s",
                "**unrequested motion**",
                "**light at the end**",
            ],
        );
        for rows in all.chunk_by(|one, next| one.fate == next.fate && motion(one) == motion(next)) {
            let most = |spread: fn(&Guarded) -> &Spread| {
                let each = rows.iter().map(|row| spread(row).most());
                format!("{:.2}", each.fold(0.0, f64::max))
            };
            let most = [
                most(|row| &row.packet_s),
                most(|row| &row.rest_s),
                most(|row| &row.went_mm),
                most(|row| &row.went_deg),
                most(|row| &row.lit_s),
                most(|row| &row.stood_s),
            ];
            let unasked: usize = rows.iter().map(|row| row.unasked).sum();
            let burnt: usize = rows.iter().map(|row| row.burnt).sum();
            let cells = format!(
                "{} | {} | {unasked} | {burnt}",
                motion(&rows[0]),
                most.join(" | ")
            );
            self.row(rows[0].fate, cells);
        }
        for result in all {
            self.wrong(result.wrong);
        }
        self.line(WATCHDOGS_END);
    }

    fn carries(&mut self, cycles: u64) {
        let result = carries::run(cycles);
        self.line(CARRIES);
        self.table(["", ""], &[]);
        self.row("cycles", result.cycles);
        self.row("grips", result.cycles * 4);
        self.row("kills", result.kills);
        self.row("lost commands, resent", result.again);
        let hours = format!("{:.1} h", result.took.as_secs_f64() / 3600.0);
        self.row("on the arm's clock", hours);
        self.row("final state of the program", &result.state);
        self.row("**cubes lost or misplaced**", u8::from(!result.is_right));
        self.line(CARRIES_END);
        if !result.is_right || result.state != "done" {
            self.wrong(vec![format!("{result:?}")]);
        }
    }

    fn cables(&mut self, pulls: u64) {
        self.line(CABLES);
        self.table(
            ["the job is", "pulls"],
            &[
                "paused, with the reason",
                "looked reset",
                "**lost**",
                "**repeated**",
                "laser off after reconnection, at most",
            ],
        );
        for result in cables::run(pulls) {
            let cells = format!(
                "{} | {} | {} | {} | {} | {:.2} s",
                result.pulls,
                result.paused,
                result.looks_reset,
                result.lost,
                result.repeated,
                result.dark_s.most()
            );
            self.row(result.during, cells);
            self.wrong(result.wrong);
        }
    }

    fn lines(&mut self, drawings: u64) {
        self.line(LINES);
        self.table(
            ["fault", "drawings"],
            &[
                "done and right",
                "paused",
                "of these spoilt",
                "failed",
                "wrong without a report",
            ],
        );
        for result in lines::run(drawings) {
            let cells = format!(
                "{} | {} | {} | {} | {} | {}",
                result.drawings,
                result.done,
                result.paused,
                result.spoilt,
                result.failed,
                result.silently_wrong
            );
            self.row(format!("`{}`", result.fault), cells);
            if result.fault.ends_with(":from") {
                self.wrong(result.example.into_iter().collect());
            }
            self.wrong(result.wrong);
        }
        self.line(LINES_END);
    }

    fn clients(&mut self, times: u64) {
        self.line(CLIENTS);
        for result in clients::run(times) {
            self.line("");
            self.times(&format!("{} ({} times)", result.how, result.times));
            self.row("to the stopping packet, s", &result.packet_s);
            self.row("to rest, or the end of the light, s", &result.over_s);
            if result.went_mm.most() > 0.0 {
                self.row("distance from there, mm", &result.went_mm);
            }
            self.row(
                "control not free afterwards",
                format!("{} | |", result.not_free),
            );
            self.wrong(result.wrong);
        }
    }

    fn floods(&mut self, floods: u64) {
        self.line(FLOODS);
        self.table(
            ["a flood of", "sent"],
            &[
                "passed on",
                "**lost by the arm**",
                "waiting at most",
                "others not served",
            ],
        );
        for result in floods::run(floods) {
            let cells = format!(
                "{} | {} | {} | {} | {}",
                result.sent,
                result.passed_on,
                result.overrun,
                result.most_waiting,
                result.not_served
            );
            self.row(result.who, cells);
            self.wrong(result.wrong);
        }
    }

    fn disks(&mut self, jobs: u64) {
        let result = disks::run(jobs);
        self.line(DISKS);
        self.table(["", ""], &[]);
        self.row("jobs, all completed", result.jobs);
        self.row("paused for it, with the reason", result.paused);
        self.row("did not need the disk again", result.done);
        self.row("**commands lost**", result.lost);
        self.row("**commands repeated**", result.repeated);
        self.row(
            "laser off after the pause, at most",
            format!("{:.2} s", result.dark_s.most()),
        );
        self.wrong(result.wrong);
    }

    fn stops(&mut self, stops: u64) {
        let all = stops::run(stops);
        let sum: usize = all.iter().map(|row| row.times).sum();
        self.line(STOPS);
        self.line(&format!("{sum} stops in all.\n"));
        self.table(
            ["the arm does", "stops"],
            &[
                "**at rest too late**",
                "**laser off too late**",
                "promised, s: middle",
                "99 %",
                "most",
                "took, s: middle",
                "99 %",
                "most",
            ],
        );
        for result in all {
            let cells = format!(
                "{} | {} | {} | {} | {}",
                result.times, result.late, result.burnt, result.promised_s, result.took_s
            );
            self.row(result.doing, cells);
            self.wrong(result.wrong);
        }
    }

    fn sessions(&mut self, sessions: u64) {
        let result = sessions::run(sessions);
        self.line(SESSIONS);
        self.table(["", ""], &[]);
        self.row("sessions", sessions);
        self.row("**sessions with an error**", result.wrong.len());
        self.row("incidents before the last stop", result.incidents);
        self.row("jobs completed", result.jobs);
        self.row("stops without a link", result.undelivered);
        self.line("");
        self.times("From the last stop");
        self.row("rest", &result.rest_s);
        self.row("end of the light, if it burned", &result.dark_s);
        self.wrong(result.wrong);
    }

    fn long_lines(&mut self, times: u64) {
        let all = long_lines::run(times);
        self.line(LONG_LINES);
        let sum: usize = all.len() * long_lines::LineEnd::ALL.len();
        self.line(&format!("{times} times each, {sum} cases.\n"));
        let ends = long_lines::LineEnd::ALL.map(|end| end.to_string());
        let columns: Vec<&str> = ends
            .iter()
            .map(String::as_str)
            .chain(["**later**"])
            .collect();
        self.table(["material or pen", "what goes on"], &columns);
        for result in all {
            let most = result
                .ends
                .map(|(_, took_s)| format!("{:.2}", took_s.most()));
            let what = if result.burns { "light" } else { "motion" };
            let cells = format!("{what} | {} | {}", most.join(" | "), result.late);
            self.row(result.material, cells);
            if result.late > 0 {
                self.wrong(vec![format!("one long line: {} too late", result.late)]);
            }
            self.wrong(result.wrong);
        }
        self.line(LONG_LINES_END);
    }

    /// Includes the table of a million requests from its file, because they take long, and runs a few.
    fn fuzz(&mut self, cases: u64) {
        self.line(FUZZ);
        self.line(include_str!("fuzz.md").trim_end());
        self.wrong(fuzz::run(0, cases).wrong);
    }

    /// Includes the results of the fleet from their file.
    fn work(&mut self) {
        self.line(WORK);
        self.line(include_str!("work.md").trim_end());
    }

    fn standing_laser(&mut self, programs: u64) {
        self.line(STANDING_LASER);
        self.table(
            ["who sends it", "link"],
            &[
                "programs",
                "**for more than 0.3 s**",
                "switched off by the station",
                "jobs reported as displaced",
                "stood, s: middle",
                "99 %",
                "most",
            ],
        );
        for result in standing_laser::run(programs) {
            let link = if result.link.is_empty() {
                "good"
            } else {
                result.link
            };
            let cells = format!(
                "`{link}` | {} | {} | {} | {} | {}",
                result.programs, result.late, result.switched_off, result.displaced, result.stood_s
            );
            self.row(result.sender, cells);
            self.wrong(result.wrong);
        }
    }

    /// Writes the head of a table of distributions.
    fn times(&mut self, what: &str) {
        self.table([what, "middle"], &["99 %", "most"]);
    }

    fn table(&mut self, first: [&str; 2], others: &[&str]) {
        let columns = [&first[..], others].concat();
        self.line(&format!("| {} |", columns.join(" | ")));
        self.line(&format!("|{}", "---|".repeat(columns.len())));
    }

    fn row(&mut self, name: impl Display, cells: impl Display) {
        self.line(&format!("| {name} | {cells} |"));
    }

    fn line(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("text can always be written to");
    }

    fn wrong(&mut self, wrong: Vec<String>) {
        self.wrong.extend(wrong);
    }
}

/// The motion of the arm, without the button: the servo's buttons are slower to stop than the others.
fn motion(row: &Guarded) -> String {
    let name = row.doing.to_string();
    match name.split_once(" jog ") {
        Some((frame, axis)) if axis.starts_with("servo") => format!("{frame} jog of the servo"),
        Some((frame, _)) => format!("{frame} jog"),
        None => name,
    }
}

const HEAD: &str = "# Reliability

For everyone who wants to know what arm, laser and drawing do when something fails. Measured with the station's supervisor,
virtual arms and a real journal in virtual time; never on a real arm.

```sh
cargo run -p dobot-examples --example reliability > docs/reliability.md    # regenerates this page
cargo run -p dobot-examples --example reliability -- --quick               # a fortieth of the cases, as CI does
cargo test -p dobot-host faults::                                          # the same cases as tests
```

Each case has a number, the seed of its random choices. Even numbers are arms of the document (`specification`), odd ones
twins (`firmware-1.1`). Jobs are, in turn, pen drawings of closed loops (some of 0.3 mm), the same loops burned, and programs
of targets with pauses. The example fails if a bold figure is not 0.

\"Lost\" and \"repeated\" count vectors and targets on the wire. Pen drawings are also compared with the paper: no ink
further than 0.3 mm from its line, no line missing.";

const KILLS: &str = "
## The station is killed

At random moments, up to three times in a job, without a watchdog. The station restarts up to five seconds later; then a
person confirms the pose and resumes the job.
";

const WATCHDOGS: &str = "
## The station is gone, and its watchdog acts

The station is killed, freezes (SIGSTOP, swap, a debugger) or panics, at a random moment of a jog at 20 to 100 % of the speed,
of a burning job, or of a motion to a point, and is not restarted. Each figure is the maximum of all cases: the time from the
last heartbeat to the first packet of the [watchdog](safety.md#watchdog), and time and distance from the end of the station to
the arm's rest and to the end of the light. Light on a spot: the laser is on while the arm stands.
";

const WATCHDOGS_END: &str = "
A jog slows down with its acceleration, in up to a second from full speed. The arm finishes what it has received: one vector
and half a second of vectors, burning included, or the motion to the point. Laser off waits behind these in the arm.";

const CARRIES: &str = "
## A program carries something, on a bad line, and is killed

A suction cup takes a cube to another place and back. One packet of a thousand has a flipped bit, in both directions. Every
fifty cycles the station is killed and restarted; a person confirms the pose and resumes the program. The arm is that of the
document: a stock arm hangs at a packet with a damaged state until it is switched off and on.
";

const CARRIES_END: &str = "
After a lost command the arm comes to rest, and the program resumes by itself.";

const CABLES: &str = "
## The cable is pulled

For up to six seconds, in each phase of a job. If afterwards the base is at exactly 0 and the joints are elsewhere, the arm
looks reset: its pose is not trusted, and the commands that it had received count as lost.
";

const LINES: &str = "
## The line is bad

The jobs are pen drawings; a paused one is not resumed. `drop=0.1%` loses one byte of a thousand, so one packet of 24. `:from`
affects statuses from the arm, `:to` commands to it.
";

const LINES_END: &str = "
Lost, damaged and late statuses do no harm. A lost command cannot be resent in time: the next ones are already sent, and are
drawn from the wrong position until the statuses show it, half a second and a vector later. Then the job is paused, and the
message names where the arm rests and where it should. One loss was not noticed (seed 52, of the document): part of a loop
of 0.36 mm is missing, and the arm rested where the drawing ends.";

const CLIENTS: &str = "
## A client vanishes

The button of a silent but connected client is released after 0.15 s (`jog.dead_man_s` of the policy). The distance is that of
the tool after the client vanished, for jogs of all speeds. A burning job is paused.";

const FLOODS: &str = "
## A client floods the station

Forty requests or packets in 50 ms, 60 times, while the arm executes a long command or a job. The arm loses packets for which
it has no room, and (not counted for stops) packets that follow another one too closely. \"Others\" are a job of another
client, which must still be drawn, and an observer, who stops the arm.
";

const DISKS: &str = "
## The disk of the journal is full

From a random moment of a job until the arm rests.
";

const STOPS: &str = "
## A stop

At a random moment. The reply promises a time within which the arm will rest; the laser must be off by then, too.
";

const SESSIONS: &str = "
## Random sessions

Up to five incidents at random moments of jobs, targets and held buttons: an observer stops the arm, the station freezes, it is
killed and its watchdog acts, the cable is pulled, the token of the client in control is removed. Each time the arm must come to rest
with the laser off, laser off must be the first packet, and jobs must end with nothing lost, repeated or spoilt. A last stop
must keep its promise.
";

const LONG_LINES: &str = "
## One long line

A line of 96 mm in each material and with each pen. In its middle the arm is stopped, the job is paused, or the station is
killed or freezes with its watchdog present. The figures are the longest times in seconds until the laser is off, or the pen
rests. Limits: 0.5 s for a laser; 0.7 s for a pen, 1.5 s in a pause, in which it slows down on its line.
";

const LONG_LINES_END: &str = "
Long lines are [split](drawing.md#how-the-plan-is-made). On a stock arm a vector that only speeds up and brakes is not: at
30 mm/s it takes up to 0.6 s, and the light lasts up to 0.9 s. A slower link needs vectors earlier, and the light lasts longer
by as much.";

const STANDING_LASER: &str = "
## The laser and an arm that stands

Burning and other vectors at random, with and without pauses between them: requests of a client, packets of a raw program, and
jobs that are paused and resumed. A stock arm leaves its laser on after a burning vector (note N36); the station switches it
off. The figures are the longest times per program with the laser on while the arm stood. With `delay` a stock arm may lose a
packet while it calculates (note N39), and the job then fails and reports that it is displaced. Lost commands may have worse
effects, because no status shows whether the laser is on.
";

const TAIL: &str = "
The promised time is an upper bound; just after a start it is the time of all commands that, by the journal, the arm may have.";

const WORK: &str = "
## Work for any arm

[Work](fleet.md#work-for-any-arm) is offered to one station after another while stations are killed and the network splits.
Afterwards the journals of all arms show which drawings were started.
";

const FUZZ: &str = "
## Any request

Requests of all kinds and packets of all states, also absurd ones (`NaN`, infinities, zero lengths), from three people, a raw
program and an observer, under three policies. A third of the cases have a fault of line, port or arm. At every control tick a
separate check compares the arm's true position with the policy. Three of four arms are stock arms.

```sh
cargo run --release -p dobot-examples --example fuzz -- --requests 1000000 > examples/rust/examples/reliability/fuzz.md
cargo run -p dobot-examples --example fuzz -- --seed 42    # one case
cargo test -p dobot-host faults::an_arm_is_never_lost         # 80,000 of them, as CI does
```

Left out: packets lost on the way to the arm, buttons held while the port is closed, wrong initial angles, and targets after a
reset.
";
