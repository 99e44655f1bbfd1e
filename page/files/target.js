// @ts-check
// Go to a place: by numbers, or by dragging the ghost on the stage. The station says while one types where the way leads,
// or why it is refused and how far it is allowed; nothing moves before Go.

/** @typedef {import("./api").components["schemas"]} Schemas */
/** @typedef {import("./stage/view.js").Ghost} Ghost */
/** @typedef {Pick<Schemas["Problem"], "detail" | "hint" | "nearest_mm">} Problem */

/** @type {readonly ("x_mm" | "y_mm" | "z_mm" | "rotation_deg")[]} */
const FIELDS = ["x_mm", "y_mm", "z_mm", "rotation_deg"];
const CHECK_MS = 80;

/** @param {string} id */
const field = (id) => /** @type {HTMLInputElement} */ (document.getElementById(`target-${id}`));

/**
 * @param {object} outside
 * @param {() => Schemas["State"] | undefined} outside.state
 * @param {(request: Schemas["Request"], answered?: (problem?: Problem, reply?: Schemas["Reply"]) => boolean | void) => void} outside.ask
 * @param {() => void} outside.changed is called when the ghost is another one
 */
export function createTarget({ state, ask, changed }) {
  const form = /** @type {HTMLFormElement} */ (document.getElementById("target"));
  const told = /** @type {HTMLElement} */ (document.getElementById("target-told"));
  const go = /** @type {HTMLButtonElement} */ (document.getElementById("target-go"));
  const clear = /** @type {HTMLButtonElement} */ (document.getElementById("target-clear"));
  const nearest = /** @type {HTMLButtonElement} */ (document.getElementById("target-nearest"));
  /** @type {Ghost | null} */ let ghost = null;
  /** @type {number[] | null} */ let allowed_mm = null;
  /** @type {number | undefined} */ let timer;
  let checks = 0;
  /** Whether the arm was sent to the ghost. */
  let goes = false;

  /** What the fields ask for, or nothing while one of them holds no number. */
  function command() {
    const arm = state()?.arm;
    const numbers = FIELDS.map((name) => field(name).valueAsNumber);
    if (!arm || numbers.some(Number.isNaN)) return undefined;
    const [x_mm, y_mm, z_mm, rotation_deg] = /** @type {[number, number, number, number]} */ (numbers);
    const mode = /** @type {HTMLSelectElement} */ (document.getElementById("target-path")).value;
    return /** @type {Schemas["Command"]} */ ({ type: "move_to", x_mm, y_mm, z_mm, rotation_deg, mode, suction: arm.suction, gripper_deg: arm.gripper_deg, pause_s: 0 });
  }

  /** @param {string} text @param {string} tone */
  function tell(text, tone) {
    if (told.textContent !== text) told.textContent = text;
    told.dataset.tone = tone;
  }

  /** Asks the station where the way would lead. */
  function check() {
    const asked = command();
    clearTimeout(timer);
    checks += 1;
    const mine = checks;
    allowed_mm = null;
    nearest.hidden = true;
    goes = false;
    // Only what was found free may be gone to.
    go.disabled = true;
    if (!asked) {
      ghost = null;
      tell("Each field takes a number.", "off");
      return changed();
    }
    const pose = /** @type {Ghost} */ (/** @type {unknown} */ (asked));
    ghost = { x_mm: pose.x_mm, y_mm: pose.y_mm, z_mm: pose.z_mm, rotation_deg: pose.rotation_deg, refused: ghost?.refused ?? false };
    changed();
    timer = setTimeout(() => ask({ type: "check_command", command: asked }, (problem, reply) => {
      if (mine === checks) hear(problem, reply);
      return true;
    }), CHECK_MS);
  }

  /** @param {Problem} [problem] @param {Schemas["Reply"]} [reply] */
  function hear(problem, reply) {
    if (!ghost) return;
    ghost = { ...ghost, refused: problem !== undefined };
    go.disabled = problem !== undefined;
    if (problem) {
      tell(`${problem.detail.charAt(0).toUpperCase()}${problem.detail.slice(1)}.`, "bad");
      allowed_mm = problem.nearest_mm ?? null;
      nearest.hidden = allowed_mm === null;
    } else if (reply?.type === "way") {
      const takes = reply.way.takes_s == null ? "" : ` It takes ${reply.way.takes_s.toFixed(1)} s.`;
      tell(`The whole way is free.${takes}`, "good");
    }
    changed();
  }

  /** @param {Pick<Ghost, "x_mm" | "y_mm" | "z_mm"> & { rotation_deg?: number }} pose */
  function fill(pose) {
    for (const name of FIELDS) {
      const value = pose[name];
      if (value !== undefined) field(name).value = value.toFixed(1);
    }
    clear.hidden = false;
    check();
  }

  function empty() {
    clearTimeout(timer);
    checks += 1;
    ghost = null;
    clear.hidden = true;
    nearest.hidden = true;
    go.disabled = true;
    form.reset();
    tell("Type a place, or drag the tip of the arm on the stage.", "off");
  }

  function forget() {
    empty();
    changed();
  }

  form.addEventListener("input", () => {
    const arm = state()?.arm;
    // What was not typed yet stays as it is.
    if (arm) for (const name of FIELDS) if (field(name).value === "" && document.activeElement !== field(name)) field(name).value = arm[name].toFixed(1);
    clear.hidden = false;
    check();
  });
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const asked = command();
    if (!asked || go.disabled) return;
    const lease = state()?.lease;
    // Where nobody has control, the first action takes it.
    if (!lease) ask({ type: "take_lease" });
    ask({ type: "command", command: asked });
    goes = true;
  });
  clear.addEventListener("click", forget);
  nearest.addEventListener("click", () => {
    if (!allowed_mm) return;
    const [x_mm, y_mm, z_mm] = /** @type {[number, number, number]} */ (allowed_mm);
    fill({ x_mm, y_mm, z_mm });
  });
  empty();

  return {
    fill,
    ghost: () => ghost,
    /** The connection is there again: what was asked before was never answered. */
    askAgain() {
      if (ghost) check();
    },
    /** Forgets the ghost when the arm that was sent there has come to it. */
    arrived() {
      const arm = state()?.arm;
      if (!ghost || !arm || !goes) return;
      const off_mm = Math.hypot(arm.x_mm - ghost.x_mm, arm.y_mm - ghost.y_mm, arm.z_mm - ghost.z_mm);
      if (off_mm < 0.3 && Math.abs(arm.rotation_deg - ghost.rotation_deg) < 0.5) forget();
    },
  };
}
