//! The figures as a document.

use std::fmt::{Display, Write};

use crate::cases::{
    cables, carries, clients, disks, floods, fuzz, kills, lines, long_lines, sessions, stands,
    stops, watchdogs,
};

/// The document, and what should not be.
#[derive(Debug, Default)]
pub(crate) struct Report {
    /// Markdown.
    pub text: String,
    /// What should not be, a line each.
    pub wrong: Vec<String>,
}

impl Report {
    /// All figures, with so many times fewer cases.
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
        self.stands(60_u64.div_ceil(fewer));
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
        self.row("while the laser burnt", result.burning);
        self.row("jobs, all of them done in the end", result.jobs);
        self.row("**commands lost**", result.lost);
        self.row("**commands repeated**", result.repeated);
        self.row("places that a person had to tell", result.unclear);
        self.row(
            "first packet after the start not laser off",
            result.not_off_first,
        );
        self.row(
            "laser on when the arm had come to rest",
            result.burnt_at_rest,
        );
        self.line("");
        self.times(
            "From the start of the new station to the end of the light, where it burnt then",
        );
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
                "way, mm",
                "way of the joint, degrees",
                "end of the light, s",
                "light on a spot, s",
                "**motion that nobody asked for**",
                "**light in the end**",
            ],
        );
        for result in all {
            let most = [
                &result.packet_s,
                &result.rest_s,
                &result.went_mm,
                &result.went_deg,
                &result.lit_s,
                &result.stood_s,
            ];
            let most = most.map(|row| format!("{:.2}", row.most())).join(" | ");
            let cells = format!(
                "{} | {most} | {} | {}",
                result.doing, result.unasked, result.burnt
            );
            self.row(result.fate, cells);
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
        self.row("commands that were lost, and sent again", result.again);
        let hours = format!("{:.1} h", result.took.as_secs_f64() / 3600.0);
        self.row("on the arm's clock", hours);
        self.row("the program is in the end", &result.state);
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
                "dark after the cable is back, at the most",
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
                "wrong and not told",
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
                self.row("way from there, mm", &result.went_mm);
            }
            self.row(
                "control not free afterwards",
                format!("{} | | |", result.not_free),
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
                "waiting at the most",
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
        self.row("jobs, all of them done in the end", result.jobs);
        self.row("paused for it, with the reason", result.paused);
        self.row("needed the disk no more", result.done);
        self.row("**commands lost**", result.lost);
        self.row("**commands repeated**", result.repeated);
        self.row(
            "dark after the pause, at the most",
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
                "**dark too late**",
                "promised, s: least",
                "middle",
                "99 %",
                "most",
                "took, s: least",
                "middle",
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
        self.row(
            "**sessions in which something was wrong**",
            result.wrong.len(),
        );
        self.row("incidents before the last stop", result.incidents);
        self.row("jobs that were done in the end", result.jobs);
        self.row("stops without a cable", result.undelivered);
        self.line("");
        self.times("From the last stop");
        self.row("rest", &result.rest_s);
        self.row("end of the light, where it burnt", &result.dark_s);
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

    /// What a million requests came to stands in a file of its own, for they take their time; a few are
    /// asked here, too.
    fn fuzz(&mut self, cases: u64) {
        self.line(FUZZ);
        self.line(include_str!("fuzz.md").trim_end());
        self.wrong(fuzz::run(0, cases).wrong);
    }

    /// What the storms of the fleet came to stands in a file of its own: the fleet is above the rules.
    fn work(&mut self) {
        self.line(WORK);
        self.line(include_str!("work.md").trim_end());
    }

    fn stands(&mut self, programs: u64) {
        self.line(STANDS);
        self.table(
            ["who sends it", "link"],
            &[
                "programs",
                "**for more than 0.3 s**",
                "switched off by the station",
                "jobs displaced, and told",
                "stood, s: least",
                "middle",
                "99 %",
                "most",
            ],
        );
        for result in stands::run(programs) {
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

    /// The head of a table of spreads.
    fn times(&mut self, what: &str) {
        self.table([what, "least"], &["middle", "99 %", "most"]);
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

const HEAD: &str = "# Reliability

This page says what happens to arm, laser and drawing when something goes wrong. The figures were measured with the
supervisor of the station, a virtual arm and a real journal in virtual time. Nothing here was measured on a real arm.

```sh
cargo run -p dobot-examples --example reliability > docs/reliability.md    # the numbers below
cargo run -p dobot-examples --example reliability -- --quick               # a fortieth of it, as CI does
cargo test -p dobot-host faults::                                         # the same, with what must hold
```

Every case has a number, counted from 0, which is the seed of all its random choices. Even numbers are arms of the
document (`specification`), odd ones are the twin of the arms that were sold (`firmware-1.1`). Jobs are, in turn, pen
drawings of closed loops (some of 0.3 mm), the same loops burned, and programs of targets with pauses. The example ends
with an error if one of the bold figures is not 0.

\"Lost\" and \"repeated\" count the vectors that draw or burn, and the targets of programs, by the packets on the wire. Pen
drawings are also compared with the paper: no ink may be further than 0.3 mm from its line, and no line may be missing.
Each line may be up to 0.1 mm longer, because of the steps of the motors.";

const KILLS: &str = "
## The station is killed

The station is killed at random moments, up to three times in a job, also while the job is paused. It is started again
up to five seconds later. Then a person confirms the pose and continues the job. There is no watchdog in these cases:
until the new station runs, nobody switches the laser off. The arm finishes what it has received, half a second and a
vector at the most, and the laser stays on.
";

const WATCHDOGS: &str = "
## The station is gone, and its watchdog is there

The station is killed, stands still (SIGSTOP, swap, a debugger), or panics. This happens at a random moment of a jog of
20 to 100 % of the speed, of a job that burns, or of a motion to a point; nobody starts the station again. Its watchdog,
a process of its own with the arm's port, acts at once when the station ends without a goodbye, and otherwise after 0.3
s without a heartbeat. Each figure is the longest or farthest of all cases: the time from the last heartbeat to the
first packet, and the time and the way from the end of the station to the arm's rest and to the end of the light. A
light on a spot is a laser that is on while the arm stands.
";

const WATCHDOGS_END: &str = "
A jog slows down with its acceleration, from full speed in half a second to a second. The arm finishes what it has
received: a vector and half a second of vectors, with their burning, or the motion to the point. Laser off waits behind
that in the arm, because the protocol has no stop.";

const CARRIES: &str = "
## A program carries something, on a bad line, and is killed

A suction cup takes a cube, carries it to another place, puts it down, takes it again and carries it back. In both
directions one packet of a thousand has a flipped bit, and every fifty cycles the station is killed and started again; a
person confirms the pose and continues the program. The arm is the virtual arm of the document.
";

const CARRIES_END: &str = "
A command that changes what is held is sent only when all before it are over, and nothing is sent behind it until a
status shows the pump or the gripper as it should be. This costs 0.35 s for each grip. If a command was lost, the arm
comes to rest, and the program continues by itself from what the arm has done. A stock arm hangs at a packet whose state
is damaged, until a person switches it off and on; no program on the computer can prevent that.
";

const CABLES: &str = "
## The cable is pulled

The cable is pulled for up to six seconds, in each phase of a job. Here, bytes that are on the line at that moment still
arrive. If the base stands at exactly 0 afterwards, as after a reset, and the joints are elsewhere, the arm may have
been reset or may have continued. Then its pose is not trusted, the commands that it had received count as lost, and the
person who confirms its pose is told so. These cases are counted separately.
";

const LINES: &str = "
## The line is bad

The jobs are pen drawings. Nobody continues a drawing that is paused. `drop=0.1%` loses one byte of a thousand, so one
packet of 24. `:from` means the statuses of the arm, `:to` the commands to it.
";

const LINES_END: &str = "
Lost, damaged and late statuses do no harm, because there will be another one. A lost command cannot be sent again in
time, because the protocol has no acknowledgement: the commands behind it are already on their way, and are drawn from
the wrong place until the statuses show it, half a second and a vector later. Then the job is paused; the message names
the place where the arm rests and the place where it should rest. A drawing that ends elsewhere than planned is reported
as failed. One loss was not noticed (seed 52, of the document): a part of a loop of 0.36 mm is missing, and the arm
rested where the drawing ends.";

const CLIENTS: &str = "
## A client vanishes

A silent client keeps its connection; its button is released after 0.15 s (`jog.dead_man_s` of the policy). The way is
the distance that the tool moves after the client vanished. Jogs are of all speeds. A job that burns is paused.";

const FLOODS: &str = "
## Somebody sends too much

Forty requests or packets come in 50 ms, 60 times, while the arm carries out a long command or a job. The arm loses
packets for which it has no room, and packets that come too soon behind another one. For stops only the former count,
because the first packet of a stop does not wait until the line is free, and is sent again. \"Others\" are a job of
another client, which must still be drawn, and somebody who may only watch, and stops the arm.
";

const DISKS: &str = "
## The disk of the journal is full

The disk becomes full at a random moment of a job, and stays full until the arm rests. Then there is room again.
";

const STOPS: &str = "
## A stop

Somebody stops the arm at a random moment. The answer says within what time it will certainly rest. The laser must be
off by then, too.
";

const SESSIONS: &str = "
## Random sessions

Up to five things go wrong one after the other, at random moments of jobs, targets and held buttons: somebody who may
only watch stops the arm, the station stands still, it is killed and its watchdog sends its packets, the cable is pulled
(and perhaps the arm is stopped meanwhile), the token of the person who has control is removed. Each time the arm has to
come to rest with its laser off, an answer to a stop has to say truly whether it was delivered, laser off has to be the
first packet, and a job has to be done in the end with nothing lost, repeated or spoilt. A last stop has to keep what it
promises.
";

const LONG_LINES: &str = "
## One long line

A line of 96 mm in each material and with each pen, which takes up to half a minute. In the middle of it somebody stops
the arm or pauses the job, or the station is killed or stands still while its watchdog is there. The figures are the
longest times in seconds from then until the laser is off, or until a pen does not move any more. A laser has to be off
within 0.5 s, and a pen has to rest within 0.7 s; in a pause it slows down on its line, and rests within 1.5 s. A marker
is drawn at 60 mm/s and speeds up for longer, which cannot be cut: 0.8 s, and 1.7 s in a pause.
";

const LONG_LINES_END: &str = "
The planner cuts long lines into vectors of 0.18 s for a laser and 0.34 s for a pen, in which the arm goes on at the same
speed. A vector that burns is sent only when it should end within `queue.ahead_s`, but early enough for the arm not to
wait. On a stock arm a vector that only speeds up and brakes is not cut; at 30 mm/s it takes up to 0.6 s, and the light
of what the arm has received lasts up to 0.9 s then. The policy refuses a vector that burns for longer than
`laser.longest_s`. A link that is slower than usual needs vectors earlier, and the light lasts longer by as much.
";

const STANDS: &str = "
## The laser and an arm that stands

Vectors that burn and others come at random, with and without time between them: as requests of a client, as packets of
a raw program, and as jobs that are paused and continued. A stock arm leaves its laser on after a burning vector (note
N36); the station switches it off. The time is the longest in a program for which the laser was on while the arm stood.
`delay` makes several packets arrive at once; a stock arm may lose one of them while it calculates (note N39). The job
then fails, and reports that it is displaced. `drop=1%:from` loses every third status, `withhold` loses all of them for
a while. Commands that a bad line loses may have worse effects, because nobody sees whether the laser is on.
";

const TAIL: &str = "
The arm has no command that stops it. It finishes the command in execution and those that it has received, which begin
within half a second (`queue.ahead_s` of the policy). The promised time is the longest that these may take,
so it is longer than the time that they take. Just after a start nobody knows what the arm was sent before. The promised
time is then the time of all commands that, by the journal, the arm may have.";

const WORK: &str = "
## Work for any arm

A drawing that is submitted to \"any arm that has a pen\" is offered to one station after another, while stations are killed and the
network falls apart (`docs/fleet.md`). After each storm the journals of all arms say which drawings were begun.
";

const FUZZ: &str = "
## Anything that anybody may ask

Requests of all kinds and packets of all states are sent: good ones, ones at the limits, and absurd ones (`NaN`,
infinities, lengths of zero). They come from three people, a raw program and a watcher. Buttons are pressed, changed and
released; there are rows of mouse and hand packets, voice, jobs, leases, stops, pulled cables and three policies. A
third of the cases have a fault: statuses are lost, damaged, doubled, late or withheld, the port is closed, the arm is
reset or its power is cut. At every control tick a separate check compares the true place of the twin with the limits of
the policy. Three arms of four are stock arms.

```sh
cargo run --release -p dobot-examples --example fuzz -- --requests 1000000 > examples/rust/examples/reliability/fuzz.md
cargo run -p dobot-examples --example fuzz -- --seed 42    # one case
cargo test -p dobot-host faults::an_arm_is_never_lost         # 80,000 of them, as CI does
```

Some cases are left out, because no station can promise anything there: packets that get lost on the way to the arm,
buttons held while the port is closed, and wrong initial angles. The places to which an arm moves after a reset are not
judged, because the arm does not know its pose then.
";
