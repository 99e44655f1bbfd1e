// A timeline for tests: 1 s of travel, a line of 40 mm in 2 s, 1 s of travel back.

/** What the file holds. */
export function sample() {
  return {
    version: 1,
    duration_s: 4,
    passes: [{ name: "sky", tool: "pen", color: [10, 20, 30] }],
    moves: { kinds: ["travel", "draw"], kind: [0, 1, 0], pass: [0, 0, 0], from_s: [0, 1, 3] },
    path: {
      t_s: [0, 1, 3, 4],
      x_mm: [200, 210, 210, 200],
      y_mm: [20, 20, -20, 20],
      z_mm: [10, 0, 0, 10],
      ink: [0, 0, 1, 0],
      error_mm: [0, 0, 0.01, 0],
    },
  };
}
