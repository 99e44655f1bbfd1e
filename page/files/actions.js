// User actions: each sends a message to the state, a request to the station, or both.

import { DEVICE, isName, saveName } from "./parts/name.js";
import { rests } from "./state/selectors.js";
import { PROGRAM_ENDINGS } from "./state/teach.js";
import { commandOf } from "./station/target.js";
import { NO_CONNECTION } from "./station/socket.js";
import { createStop } from "./station/stop.js";

/** @typedef {import("./state/types.js").Request} Request */
/** @typedef {import("./state/types.js").Command} Command */
/** @typedef {import("./state/types.js").Schemas} Schemas */
/** @typedef {import("./state/state.js").Question} Question */
/** @typedef {ReturnType<typeof createActions>} Actions */

/** Arming time of the laser; the policy may set a shorter one. */
const ARM_S = 300;
const PEN_SCENE = "[pen]\n";
/** How long a command waits for the arm to run down, by the station's clock. */
const RUN_DOWN_S = 1;
/** Fraction of the status period after which a refused command is retried. States cannot be counted: each refusal causes one. */
const AGAIN = 0.9;
/** More than the backlash of any joint. */
const RUN_UP_DEG = 6;

/** @param {import("./state/types.js").Problem | undefined} problem */
const isStillMoving = (problem) => problem?.type?.endsWith("/still-moving") ?? false;

/**
 * @param {object} outside
 * @param {import("./state/store.js").Store} outside.store
 * @param {import("./station/socket.js").Socket} outside.socket
 * @param {import("./station/http.js").Http} outside.http
 * @param {import("./station/set_up.js").SetUpRequests} outside.setUp
 * @param {import("./station/calibrate.js").CalibrateRequests} outside.calibrate
 * @param {import("./station/recordings.js").RecordingRequests} outside.recordings
 * @param {import("./station/lessons.js").Lessons} outside.lessons
 * @param {import("./station/jobs.js").JobRequests} outside.jobs
 * @param {import("./station/teach.js").TeachRequests} outside.teach
 * @param {import("./station/buttons.js").ButtonRequests} outside.buttons
 * @param {import("./station/look.js").LookRequests} outside.look
 * @param {import("./station/talk.js").TalkRequests} outside.talk
 * @param {import("./station/photo.js").PhotoRequests} outside.photo
 * @param {import("./station/files.js").FileRequests} outside.files
 * @param {import("./station/alerts.js").AlertRequests} outside.alerts
 */
export function createActions({ store, socket, http, setUp, calibrate, recordings, lessons, jobs, teach, buttons, look, talk, photo, files, alerts }) {
  const { send } = store;
  /** Number of stops so far, by this page or another client. */
  let stops = 0;
  /** Resolvers that wait for the next state. @type {(() => void)[]} */ const waiting = [];

  store.subscribe((page, message) => {
    if (message.type === "stop_pressed" || message.type === "closed" || (message.type === "state" && page.station?.stop)) stops += 1;
    if (message.type === "state" || message.type === "closed") for (const heard of waiting.splice(0)) heard();
  });

  /** Sends a request and shows a refusal to the whole page. @param {Request} request @returns {Promise<boolean>} whether it is done */
  async function ask(request) {
    const { problem } = await socket.ask(request);
    if (problem) send({ type: "problem", problem });
    return problem === undefined;
  }

  /** The time of the station. */
  const at_s = () => store.page.station?.at_s ?? 0;

  /** The next state, or the end of the connection. @returns {Promise<void>} */
  const nextState = () => new Promise((heard) => waiting.push(heard));

  /** Waits for the next status. @param {number} before number of stops before the request @returns {Promise<boolean>} whether the arm was not stopped meanwhile */
  async function isFreeLater(before) {
    const again_s = at_s() + AGAIN * (store.page.facts?.status_period_s ?? 0);
    do await nextState();
    while (stops === before && at_s() < again_s);
    return stops === before;
  }

  /**
   * Sends a command. While the arm runs down it is retried with each status, for one second, unless the arm is stopped.
   * @param {Command} command
   */
  async function command(command) {
    socket.takeControlIfFree();
    const before = stops, until_s = at_s() + RUN_DOWN_S;
    let { problem } = await socket.ask({ type: "command", command });
    while (isStillMoving(problem) && at_s() < until_s) {
      if (!(await isFreeLater(before))) return false;
      ({ problem } = await socket.ask({ type: "command", command }));
    }
    if (problem) send({ type: "problem", problem });
    return problem === undefined;
  }

  /** Moves to joint angles and keeps the tool state. @param {{ base_deg?: number, rear_deg?: number, fore_deg?: number, servo_deg?: number, gripper_deg?: number }} to */
  async function moveJoints(to) {
    const arm = store.page.station?.arm;
    if (!arm) return false;
    const { base_deg, rear_deg, fore_deg, servo_deg, suction, gripper_deg } = arm;
    return command({ type: "move_joints", base_deg, rear_deg, fore_deg, servo_deg, suction, gripper_deg, mode: "movj", pause_s: 0, ...to });
  }

  /** Turns the base of a calibrated arm straight ahead, then sends the calibrated angles to the arm, unless the arm is stopped. */
  async function sendAngles() {
    const before = stops;
    // From the right, so that the backlash is on the same side as in the calibration.
    if (!(await moveJoints({ base_deg: -RUN_UP_DEG })) || !(await moveJoints({ base_deg: 0 }))) return;
    /** @type {import("./state/types.js").Answer | null} */ let answer;
    do {
      if (!(await isFreeLater(before))) return;
      const { station } = store.page;
      // A state sent before the arm turned reports it at rest: the station knows better and refuses.
      answer = station && rests(station) ? await socket.ask({ type: "set_angles" }) : null;
    } while (!answer || isStillMoving(answer.problem));
    if (answer.problem) send({ type: "problem", problem: answer.problem });
  }

  /** Whether the station answered a stop; a refusal is shown. @param {Promise<{ problem?: import("./state/types.js").Problem }>} answer */
  async function isAnswered(answer) {
    const { problem } = await answer;
    if (!problem) return true;
    // Only a station gives a problem a type.
    const isAnswer = problem.type !== undefined && problem !== NO_CONNECTION.problem;
    if (isAnswer) send({ type: "problem", problem });
    return isAnswer;
  }

  const stopByRequest = () => isAnswered(http.stop("api/v1/stop", { name: store.page.name || null, device: DEVICE }));
  const pressStop = createStop({
    first: () => (socket.isOpen() ? isAnswered(socket.ask({ type: "stop" })) : stopByRequest()),
    again: stopByRequest,
    late: () => send({ type: "stop_late" }),
    answered: (after_ms) => send({ type: "stop_answered", after_s: after_ms / 1000 }),
  });

  /** Stops the arm over every channel, before anything else. */
  function stop() {
    pressStop();
    send({ type: "stop_pressed" });
  }

  /** Arming time of the laser, in seconds. */
  const arming_s = () => Math.min(ARM_S, store.page.policy?.laser.arm_for_s ?? ARM_S);

  /** Carries out a confirmed question. @param {Question} question @returns {Promise<unknown>} */
  function confirmed({ about, values }) {
    switch (about) {
      case "arm_laser":
        return ask({ type: "arm_laser", for_s: arming_s() });
      case "detect":
        return setUp.detect();
      case "clear_calibration":
        return calibrate.forget();
      case "send_angles":
        return sendAngles();
      case "remove_token":
        return setUp.removeToken(String(values?.name));
      default:
        return ask({ type: about });
    }
  }

  /** Sets the name of the person at this page; empty for none. @param {string} name */
  function setName(name) {
    if (name !== "" && !isName(name)) return;
    saveName(name, store.page.fleet !== null);
    const isNew = name !== (store.page.name ?? "");
    send({ type: "name", name });
    if (isNew) socket.again();
  }

  return {
    setName,
    send, ask, command, stop, arming_s, setUp, calibrate, recordings, lessons, jobs, teach, buttons, look, talk, photo, files, alerts,

    /** Asks for confirmation. @param {Question} question */
    question: (question) => send({ type: "question", question }),

    /** @param {boolean} yes */
    answer(yes) {
      const { question } = store.page;
      send({ type: "question", question: null });
      if (!yes || !question) return;
      void confirmed(question);
    },

    go() {
      const { target } = store.page;
      const to = commandOf(store.page);
      // Only a target with a free path may be approached.
      if (!to || target.check.type !== "free") return;
      void command(to).then((done) => done && target.revision === store.page.target.revision && send({ type: "target_goes" }));
    },

    /** Moves to the power-up pose of a stock arm. */
    home: () => void moveJoints({ base_deg: 0, rear_deg: 45, fore_deg: 45, servo_deg: 0 }),

    /** @param {boolean} on */
    suction: (on) => command({ type: "joint_jog", axis: on ? "suction_on" : "suction_off", speed_percent: 0 }),

    /** Moves only the gripper. @param {number} gripper_deg */
    grip: (gripper_deg) => void moveJoints({ gripper_deg }),

    /** Opens a program, a drawing, or a timeline in the preview. @param {File} file */
    openFile(file) {
      if (PROGRAM_ENDINGS.some((ending) => file.name.toLowerCase().endsWith(ending))) {
        send({ type: "tab", tab: "teach" });
        return void teach.open(file);
      }
      send({ type: "tab", tab: "draw" });
      if (!/\.json$/i.test(file.name)) return send({ type: "draw_file", file });
      // Reading a large timeline takes a second, and STOP cannot wait for it.
      const reader = new Worker(new URL("preview/reader.js", import.meta.url), { type: "module" });
      /** @param {import("./preview/timeline.js").Timeline | undefined} timeline */
      const read = (timeline) => {
        reader.terminate();
        send(timeline ? { type: "draw_timeline", timeline } : { type: "draw_file", file });
      };
      reader.onmessage = ({ data }) => read(data.timeline);
      reader.onerror = () => read(undefined);
      reader.postMessage(file);
    },

    /** Opens a stored file. @param {import("./state/files.js").StoredFile} file */
    openStored: (file) => void files.open(file, (program) => void teach.open(program)),

    /** Creates a job from the drawing or its frame, and starts it. @param {Schemas["DrawingPart"]} part */
    async draw(part) {
      const { problem } = await jobs.run(`api/v1/drawings/${store.page.draw.drawing}/jobs`, { part });
      if (problem) send({ type: "problem", problem });
    },

    /** Takes the arm's current height as that of the pen on the paper. */
    useHeight: () => send({ type: "draw_set", set: { down: (store.page.station?.arm?.z_mm ?? 0).toFixed(1) } }),

    /** Gives the virtual arm a pen and paper. */
    async addPen() {
      const { problem } = await http.ask("PUT", "api/v1/world", { scene: PEN_SCENE });
      if (problem) send({ type: "problem", problem });
    },

    /** @param {number} by_mm */
    raiseJob(by_mm) {
      const now_mm = store.page.station?.job?.height_mm ?? 0;
      void ask({ type: "set_job_height", offset_mm: Math.round((now_mm + by_mm) * 10) / 10 });
    },

    /** @param {string} secret @param {() => void} connect */
    useToken(secret, connect) {
      http.useToken(secret);
      connect();
    },
  };
}
