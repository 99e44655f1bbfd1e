//! Raw programs: they speak the arm's own protocol, and the station's rules hold for them too.

use std::time::Duration;

use dobot_wire::{Command, Packet};

use super::Keeper;
use super::amend::amended;
use crate::words::{ClientId, Jog, News, Refusal};

impl Keeper {
    /// Takes a packet of a raw program. The first one takes the lease if nobody has it.
    ///
    /// # Errors
    ///
    /// [`Refusal`]; the packet is not sent then, and all who watch are told.
    pub fn handle_raw(
        &mut self,
        now: Duration,
        client: ClientId,
        packet: &Packet,
    ) -> Result<(), Refusal> {
        self.handle_time(now);
        let taken = self.take_raw(client, packet);
        if let Err(refusal) = &taken {
            self.tell_refused(client, refusal);
        }
        self.pump();
        taken
    }

    fn take_raw(&mut self, client: ClientId, packet: &Packet) -> Result<(), Refusal> {
        let taken = self.leases.handle_program(self.arm.now(), client);
        self.follow_lease(taken);
        self.leases.check(client)?;
        let packet = &self.amended(client, packet);
        let command = self.arm.session().parse(packet)?;
        let patience_s = self.arm.policy().jog.raw_dead_man_s;
        match command {
            Command::JointJog(jog) => self.jog(client, Jog::Joint(jog), patience_s),
            Command::LinearJog(jog) => self.jog(client, Jog::Linear(jog), patience_s),
            command => {
                // Another packet than that of the button means that it is not held any more.
                self.let_go();
                self.command(client, &command)
            }
        }
        .map(|_| ())
    }

    /// The packet with what a stock arm would take harmlessly put right; those who watch are told, once
    /// for all that follow and are changed alike.
    fn amended(&mut self, client: ClientId, packet: &Packet) -> Packet {
        let model = self
            .arm
            .session()
            .model()
            .filter(|_| self.arm.session().dialect().is_some());
        let changed = model.and_then(|model| amended(packet, model, self.arm.policy()));
        let Some((sent, what)) = changed else {
            return *packet;
        };
        let text = format!("{}: {what}", self.name(client));
        if self.leases.handle_amended(client, &text) {
            self.tell(News::Amended { client }, text);
        }
        sent
    }

    /// Tells all who watch that something was refused.
    pub(super) fn tell_refused(&mut self, client: ClientId, refusal: &Refusal) {
        if self.jogging.is_told(client, refusal) {
            return;
        }
        // The arm's own protocol has no words for that: whoever reads this is the only one to know.
        let is_program = self.leases.is_program(client);
        let remedy = refusal
            .hint()
            .or_else(|| is_program.then(|| GOES_ON.into()));
        let remedy = remedy.map_or_else(String::new, |it| format!("; {it}"));
        let text = format!("refused to {}: {refusal}{remedy}", self.name(client));
        let kind = refusal.kind().to_owned();
        self.tell(News::Refused { client, kind }, text);
    }
}

/// What to do about a packet that nothing helps.
const GOES_ON: &str = "send what is allowed; the arm goes on as if this had not been sent";
