//! The serial ports of this machine.

use tokio_serial::{SerialPortType, UsbPortInfo, available_ports};

/// A serial port of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Port {
    /// The name as used in an address, such as `/dev/ttyUSB0`.
    pub path: String,
    /// The device description, if the operating system provides one.
    pub device: Option<String>,
    /// The USB identification, for a USB port.
    pub usb: Option<Usb>,
}

/// The USB identification of a serial adapter.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Usb {
    /// The USB vendor ID.
    pub vendor: u16,
    /// The USB product ID.
    pub product: u16,
    /// The serial number, if the adapter has one.
    pub serial: Option<String>,
}

/// Lists the serial ports of this machine without opening them, so no arm is reset.
///
/// # Errors
///
/// Returns the error of the operating system.
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
