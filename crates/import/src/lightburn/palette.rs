//! The colours of the layers.

/// The colour of a layer number, as in `LightBurn`.
pub(super) fn color(index: u32) -> Option<[u8; 3]> {
    let rgb = *PALETTE.get(usize::try_from(index).ok()?)?;
    let [_, red, green, blue] = rgb.to_be_bytes();
    Some([red, green, blue])
}

/// C00 to C29, and the tool layers T1 and T2.
const PALETTE: [u32; 32] = [
    0x00_00_00, 0x00_00_ff, 0xff_00_00, 0x00_e0_00, 0xd0_d0_00, 0xff_80_00, 0x00_e0_e0, 0xff_00_ff,
    0xb4_b4_b4, 0x00_00_a0, 0xa0_00_00, 0x00_a0_00, 0xa0_a0_00, 0xc0_80_00, 0x00_a0_ff, 0xa0_00_a0,
    0x80_80_80, 0x7d_87_b9, 0xbb_77_84, 0x4a_6f_e3, 0xd3_3f_6a, 0x8c_d7_8c, 0xf0_b9_8d, 0xf6_c4_e1,
    0xfa_9e_d4, 0x50_0a_78, 0xb4_5a_00, 0x00_47_54, 0x86_fa_88, 0xff_db_66, 0xf3_69_26, 0x0c_96_d9,
];
