//! The serial ports of this machine.

use tokio_serial::{SerialPortType, UsbPortInfo, available_ports};

/// A serial port of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// Its name, as an address takes it.
    pub path: String,
    /// What is plugged in, where the system tells.
    pub device: Option<String>,
    /// Which USB chip it is, if it is one.
    pub usb: Option<Usb>,
}

/// A USB chip with a serial port.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Usb {
    /// Whose chip it is, by the number that the USB organisation gave him.
    pub vendor: u16,
    /// Which of his chips.
    pub product: u16,
    /// Which one of these, where the chip has a number of its own.
    pub serial: Option<String>,
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
            usb: usb(&info.port_type),
            device: device(info.port_type),
        })
        .collect();
    ports.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(ports)
}

fn usb(kind: &SerialPortType) -> Option<Usb> {
    let SerialPortType::UsbPort(UsbPortInfo {
        vid,
        pid,
        serial_number,
        ..
    }) = kind
    else {
        return None;
    };
    Some(Usb {
        vendor: *vid,
        product: *pid,
        serial: serial_number.clone(),
    })
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
