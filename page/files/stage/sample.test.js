// What a station serves of an arm, as a sample for tests.

const tool = (kind, reach_mm, length_mm) => ({ kind, reach_mm, length_mm, gesture: null });

export const FACTS = {
  dimensions: { rear_arm_mm: 135, forearm_mm: 160, crank_mm: 42, rear_rod_at_mm: [-27, 22], front_rod_at_mm: [20, 22], pivot_above_table_mm: 103 },
  tools: [tool("suction_cup", 55.07, 40), tool("gripper", 55.07, 40), tool("pen", 55.07, 40), tool("laser", 49.57, 38)],
  joints: { base_deg: [-135, 135], rear_deg: [-5, 85], fore_deg: [-10, 95], servo_deg: [-90, 90], opening_deg: [-105, 35] },
  workspace: { x_mm: [-321, 321], y_mm: [-321, 321], z_mm: [-103, 136], reach_mm: [129, 321] },
  status_period_s: 0.08, tick_s: 0.02, packet_gap_s: 0.06, dialect: null,
};

/** The arm with a suction cup, and with the laser. */
export const CUP = { ...FACTS.dimensions, reach_mm: 55.07 }, LASER = { ...FACTS.dimensions, reach_mm: 49.57 };
