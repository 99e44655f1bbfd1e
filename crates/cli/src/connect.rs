//! From an address to a connection.

use dobot_client::{Address, Connection};
use dobot_controller::{Controller, Personality, PowerUp};
use dobot_sim::{InProcess, Line, VirtualArm};
use dobot_wire::Dialect;

use crate::failure::Failure;

/// Which arm.
#[derive(Clone, Debug, clap::Args)]
pub(crate) struct To {
    /// The arm's address.
    #[arg(
        long = "to",
        value_name = "ADDRESS",
        default_value = "virtual:",
        global = true,
        help = "The arm's address: virtual:, serial:PORT[@BAUD] or tcp:HOST:PORT"
    )]
    pub(crate) address: Address,
    /// What the arm understands: specification, or firmware-1.1 for an arm as it was sold
    ///
    /// A virtual arm speaks the specification unless told otherwise; over a port nobody knows until it is
    /// told here, and what depends on it is refused.
    #[arg(long, value_name = "DIALECT", global = true)]
    pub(crate) dialect: Option<Dialect>,
}

/// A connection, and the virtual arm at its other end if it is one in this process.
pub(crate) struct Connected {
    pub(crate) arm: Connection,
    pub(crate) virtual_arm: Option<InProcess>,
}

impl To {
    pub(crate) const fn is_virtual(&self) -> bool {
        matches!(self.address, Address::Virtual)
    }

    pub(crate) async fn connect(&self) -> Result<Connected, Failure> {
        if !self.is_virtual() {
            return Ok(Connected {
                arm: Connection::open(&self.address, self.dialect).await?,
                virtual_arm: None,
            });
        }
        let dialect = self.dialect.unwrap_or(Dialect::SPECIFICATION);
        let virtual_arm = InProcess::new(virtual_arm(speaker(dialect)));
        Ok(Connected {
            arm: Connection::over_peer(virtual_arm.clone(), Some(dialect)),
            virtual_arm: Some(virtual_arm),
        })
    }
}

/// A virtual arm at the end of a line as slow as that of a stock arm.
pub(crate) fn virtual_arm(personality: Personality) -> VirtualArm {
    let controller = Controller::power_up(PowerUp::new(personality));
    VirtualArm::new(controller, Line::STOCK)
}

/// The controller that speaks a dialect.
fn speaker(dialect: Dialect) -> Personality {
    Personality::ALL
        .into_iter()
        .find(|it| it.dialect() == dialect)
        .expect("each dialect has a controller that speaks it")
}
