use super::*;

fn usb(path: &str, vendor: u16, product: u16, serial: Option<&str>) -> Port {
    Port {
        path: path.into(),
        device: None,
        usb: Some(Usb {
            vendor,
            product,
            serial: serial.map(str::to_owned),
        }),
    }
}

fn plain(path: &str) -> Port {
    Port {
        path: path.into(),
        device: None,
        usb: None,
    }
}

fn ch340(path: &str) -> Port {
    usb(path, 0x1a86, 0x7523, None)
}

fn found_at(port: &Port, baud: u32) -> Search {
    Search {
        last: Some(KnownPort {
            path: port.path.clone(),
            baud,
            usb: port.usb.clone(),
        }),
        ..Search::default()
    }
}

fn addresses(search: &Search, ports: &[Port]) -> Vec<String> {
    let choice = choose(search, ports);
    let text = |candidate: &Candidate| candidate.address.to_string();
    choice.candidates.iter().map(text).collect()
}

#[test]
fn usb_chips_of_arms_come_before_other_usb_chips_and_ports_without_usb_are_never_tried() {
    let ports = [
        usb("/dev/ttyACM0", 0x1234, 0x5678, None),
        plain("/dev/ttyAMA0"),
        plain("/dev/ttyS0"),
        ch340("/dev/ttyUSB0"),
        usb("/dev/ttyUSB1", 0x0403, 0x6001, Some("A1")),
    ];
    let choice = choose(&Search::default(), &ports);
    assert_eq!(
        addresses(&Search::default(), &ports),
        [
            "serial:/dev/ttyUSB0@9600",
            "serial:/dev/ttyUSB1@9600",
            "serial:/dev/ttyACM0@9600"
        ]
    );
    assert_eq!(choice.passed_over, ["/dev/ttyAMA0", "/dev/ttyS0"]);
    assert!(choice.candidates.iter().all(|candidate| !candidate.sure));
}

#[test]
fn the_udev_rule_of_a_release_has_every_kind_of_usb_chip_in_arms() {
    let rules = include_str!("../../../../../release/60-dobot.rules");
    let field = |line: &str, name: &str| {
        let value = line.split_once(&format!("ATTRS{{{name}}}==\""))?.1;
        u16::from_str_radix(value.get(..4)?, 16).ok()
    };
    let ruled: Vec<_> = rules
        .lines()
        .filter_map(|line| Some((field(line, "idVendor")?, field(line, "idProduct")?)))
        .collect();
    assert_eq!(ruled, LIKELY);
}

#[test]
fn every_kind_of_usb_chip_in_arms_comes_first() {
    for (vendor, product) in [
        (0x2341, 0x0010),
        (0x2341, 0x0042),
        (0x1a86, 0x7523),
        (0x0403, 0x6001),
        (0x10c4, 0xea60),
    ] {
        let ports = [
            usb("/dev/ttyACM0", 0x1d50, 0x6018, None),
            usb("/dev/ttyACM1", vendor, product, None),
        ];
        let first = &addresses(&Search::default(), &ports)[0];
        assert_eq!(first, "serial:/dev/ttyACM1@9600", "{vendor:04x}");
    }
}

#[test]
fn the_port_with_the_last_arm_comes_first_at_its_baud_rate() {
    let ports = [ch340("/dev/ttyUSB0"), ch340("/dev/ttyUSB1")];
    let search = found_at(&ports[1], 115_200);
    let choice = choose(&search, &ports);
    assert_eq!(
        choice.candidates[0].address.to_string(),
        "serial:/dev/ttyUSB1@115200"
    );
    assert!(choice.candidates[0].sure);
    assert!(!choice.candidates[1].sure);
}

#[test]
fn a_chip_with_a_serial_number_is_recognised_at_any_port() {
    let was = usb("/dev/ttyACM0", 0x2341, 0x0042, Some("7543"));
    let ports = [
        usb("/dev/ttyACM0", 0x2341, 0x0042, Some("1111")),
        usb("/dev/ttyACM3", 0x2341, 0x0042, Some("7543")),
    ];
    let choice = choose(&found_at(&was, 9600), &ports);
    assert_eq!(
        choice.candidates[0].address.to_string(),
        "serial:/dev/ttyACM3@9600"
    );
    assert!(choice.candidates[0].sure);
    assert!(!choice.candidates[1].sure);
}

#[test]
fn a_chip_without_a_serial_number_at_a_new_port_comes_first_but_is_not_sure() {
    let ports = [
        usb("/dev/ttyACM0", 0x2341, 0x0042, None),
        ch340("/dev/ttyUSB1"),
    ];
    let choice = choose(&found_at(&ch340("/dev/ttyUSB0"), 9600), &ports);
    assert_eq!(
        choice.candidates[0].address.to_string(),
        "serial:/dev/ttyUSB1@9600"
    );
    assert!(!choice.candidates[0].sure);
}

#[test]
fn another_device_at_the_port_name_of_the_arm_is_not_mistaken_for_it() {
    let ports = [usb("/dev/ttyUSB0", 0x067b, 0x2303, None)];
    let choice = choose(&found_at(&ch340("/dev/ttyUSB0"), 9600), &ports);
    assert!(!choice.candidates[0].sure);
}

#[test]
fn a_port_without_usb_is_tried_again_if_an_arm_was_found_there() {
    let ports = [plain("/dev/ttyS0"), plain("/dev/ttyS1")];
    let found = addresses(&found_at(&ports[1], 9600), &ports);
    assert_eq!(found, ["serial:/dev/ttyS1@9600"]);
}

#[test]
fn ports_named_by_the_user_are_tried_in_that_order_and_no_others() {
    let search = Search {
        named: ["serial:/dev/ttyS0", "tcp:localhost:5555"]
            .map(|address| address.parse().expect("it is an address"))
            .into(),
        ..found_at(&ch340("/dev/ttyUSB0"), 9600)
    };
    let choice = choose(&search, &[ch340("/dev/ttyUSB0"), plain("/dev/ttyS0")]);
    let found: Vec<_> = choice
        .candidates
        .iter()
        .map(|candidate| candidate.address.to_string())
        .collect();
    assert_eq!(found, ["serial:/dev/ttyS0@9600", "tcp:localhost:5555"]);
    assert!(choice.candidates.iter().all(|candidate| candidate.sure));
    assert!(choice.passed_over.is_empty());
}

#[test]
fn other_baud_rates_are_tried_on_request_after_all_ports_at_the_usual_one() {
    let search = Search {
        other_bauds: vec![256_000, 9600],
        ..Search::default()
    };
    let ports = [ch340("/dev/ttyUSB0"), ch340("/dev/ttyUSB1")];
    assert_eq!(
        addresses(&search, &ports),
        [
            "serial:/dev/ttyUSB0@9600",
            "serial:/dev/ttyUSB1@9600",
            "serial:/dev/ttyUSB0@256000",
            "serial:/dev/ttyUSB1@256000"
        ]
    );
}
