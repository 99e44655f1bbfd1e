//! The serial ports of this machine.

use tokio_serial::{SerialPortType, available_ports};

/// A serial port of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its name, as an address takes it.
    pub path: String,
    /// What is plugged in, where the system tells.
    pub device: Option<String>,
}

/// Lists the serial ports of this machine; opens none, so no arm is reset.
///
/// # Errors
///
/// What the operating system says.
pub fn ports() -> std::io::Result<Vec<Port>> {
    let mut ports: Vec<Port> = available_ports()?
        .into_iter()
        .map(|info| Port {
            path: info.port_name,
            device: device(info.port_type),
        })
        .collect();
    ports.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(ports)
}

fn device(kind: SerialPortType) -> Option<String> {
    match kind {
        SerialPortType::UsbPort(usb) => {
            let names = [usb.manufacturer, usb.product];
            let name = names.into_iter().flatten().collect::<Vec<_>>().join(" ");
            Some(
                format!("USB {:04x}:{:04x} {name}", usb.vid, usb.pid)
                    .trim_end()
                    .to_owned(),
            )
        }
        SerialPortType::BluetoothPort => Some("Bluetooth".into()),
        SerialPortType::PciPort => Some("PCI".into()),
        SerialPortType::Unknown => None,
    }
}
