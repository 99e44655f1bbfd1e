// The camera: asked for when the view opens, off when it closes. A worker looks at its pictures. Moves to what was seen go to the
// station marked as the camera's; it checks them like all others.

import { isSecure, refusalOf, stopTracks } from "./media.js";
import { ABOVE_MM, HUES, askedThing, lookBlockedReason, paperHeight, thingsOf, transferBlockedReason } from "../state/look.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {ReturnType<typeof createLook>} LookRequests */
/** @typedef {import("../state/look.js").Thing} Thing */

const WIDTH = 640;
/** The least time between two pictures: 15 a second at most. */
const BETWEEN_MS = 66;
/** How many pictures show an object within this distance before a program is answered. */
const STEADY = 3, STEADY_MM = 1;
/** How far over an object the tool comes and goes, in mm. */
const APPROACH_MM = 30;
/** How long the cup takes to grip and to release. */
const SETTLE_S = 0.3;
const HEIGHTS = "dobot.heights";

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket @param {import("./jobs.js").JobRequests} jobs */
export function createLook(store, http, socket, jobs) {
  const { send } = store;
  const video = document.createElement("video");
  video.id = "look-video";
  video.muted = video.playsInline = true;
  /** @type {MediaStream | null} */ let stream = null;
  /** @type {Worker | null} */ let worker = null;
  /** @type {number | undefined} */ let timer;
  /** The last times at which pictures were looked at. @type {number[]} */ let times = [];
  /** When the last picture was taken. */
  let taken = 0;
  /** Where the object that a program asks for was in the last pictures. @type {Thing[]} */ let steady = [];
  /** Counts openings: an answer to an earlier question for the camera is ignored. */
  let openings = 0;
  /** Whether the station took the last move, and no state has shown it yet. */
  let isTaken = false;
  for (const [name, height_mm] of Object.entries(JSON.parse(localStorage.getItem(HEIGHTS) ?? "{}"))) send({ type: "look_height", name, height_mm: Number(height_mm) });

  const canvas = document.createElement("canvas");
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d", { willReadFrequently: true }));

  function take() {
    taken = performance.now();
    if (!worker || !video.videoWidth) return void (timer = setTimeout(take, BETWEEN_MS));
    [canvas.width, canvas.height] = [WIDTH, Math.round((WIDTH * video.videoHeight) / video.videoWidth)];
    context.drawImage(video, 0, 0, canvas.width, canvas.height);
    const { data, width, height } = context.getImageData(0, 0, canvas.width, canvas.height);
    const { hue } = store.page.look;
    worker.postMessage({ picture: { data, width, height }, hue_deg: hue ? HUES[hue] : null }, [data.buffer]);
  }

  /** @param {import("../vision/look.js").Seen} seen */
  function looked(seen) {
    const now = performance.now();
    times = [...times, now].slice(-11);
    const rate = times.length > 1 ? ((times.length - 1) * 1000) / (now - times[0]) : 0;
    send({ type: "look_seen", seen, rate });
    timer = setTimeout(take, Math.max(0, BETWEEN_MS - (now - taken)));
    answerProgram();
  }

  /** Answers a running program that asks where a marker is, once the marker rests. */
  function answerProgram() {
    const { page } = store, job = page.station?.job;
    const thing = page.look.answers ? askedThing(page) : null;
    steady = thing ? [...steady, thing].slice(-STEADY) : [];
    const paper_mm = thing && paperHeight(page, thing);
    if (!job || !thing || paper_mm === null || steady.length < STEADY || steady.some((other) => other.name !== thing.name || Math.hypot(other.x_mm - thing.x_mm, other.y_mm - thing.y_mm) > STEADY_MM)) return;
    steady = [];
    const { x_mm, y_mm, turn_deg } = thing;
    void socket.ask({ type: "answer_job", job: job.job, answer: { place: { name: thing.name, x_mm, y_mm, z_mm: paper_mm + (thing.height_mm ?? 0), rotation_deg: turn_deg, sense: "camera" } } });
  }

  async function open() {
    close();
    const mine = (openings += 1);
    const { mediaDevices } = navigator;
    if (!isSecure()) return send({ type: "look_camera", camera: "off", refused: "insecure" });
    send({ type: "look_camera", camera: "asking" });
    const { chosen } = store.page.look;
    try {
      /** @type {import("../state/types.js").Schemas["SheetPoints"] | undefined} */
      const sheet = await http.json("api/v1/calibration/points");
      const own = await mediaDevices.getUserMedia({ video: { width: { ideal: WIDTH }, ...(chosen && { deviceId: { exact: chosen } }) }, audio: false });
      if (mine !== openings) return stopTracks(own);
      if (!sheet) return send({ type: "look_camera", camera: "off", refused: "no_connection" });
      stream = own;
      const [track] = own.getVideoTracks();
      track.onended = () => {
        close();
        send({ type: "look_camera", camera: "off", refused: "unplugged" });
      };
      video.srcObject = own;
      await video.play();
      worker = new Worker(new URL("../vision/worker.js", import.meta.url), { type: "module" });
      worker.onmessage = ({ data }) => looked(data);
      worker.onerror = ({ message }) => {
        close();
        send({ type: "look_camera", camera: "off", refused: message });
      };
      worker.postMessage({ sheet: sheet.markers_mm });
      send({ type: "look_camera", camera: "on" });
      take();
      const cameras = (await mediaDevices.enumerateDevices()).filter(({ kind }) => kind === "videoinput").map(({ deviceId, label }) => ({ id: deviceId, label }));
      send({ type: "look_cameras", cameras });
    } catch (error) {
      if (mine !== openings) return;
      close();
      send({ type: "look_camera", camera: "off", refused: refusalOf(error) });
    }
  }

  function close() {
    openings += 1;
    clearTimeout(timer);
    worker?.terminate();
    stopTracks(stream);
    [worker, stream, video.srcObject, times, steady] = [null, null, null, [], []];
  }

  let tab = store.page.tab;
  store.subscribe((page, message) => {
    if (page.tab !== tab) {
      const was = tab;
      tab = page.tab;
      if (tab === "look") void open();
      else if (was === "look") {
        close();
        send({ type: "look_camera", camera: "off" });
      }
    }
    if (isTaken && (message.type === "state" || message.type === "closed")) {
      isTaken = false;
      send({ type: "look_set", set: { is_sent: false } });
    }
    if (message.type === "look_height") localStorage.setItem(HEIGHTS, JSON.stringify(page.look.heights));
  });

  /** Sends the tool to a place as the camera's. @param {{ x_mm: number, y_mm: number }} place @param {number} above_mm @param {"movj" | "movl"} mode */
  async function move({ x_mm, y_mm }, above_mm, mode) {
    const arm = store.page.station?.arm;
    const paper_mm = paperHeight(store.page, { x_mm, y_mm });
    if (!arm || paper_mm === null || lookBlockedReason(store.page)) return false;
    socket.takeControlIfFree();
    const z_mm = paper_mm + above_mm;
    const { suction, gripper_deg, rotation_deg } = arm;
    send({ type: "look_set", set: { is_sent: true } });
    const { problem } = await socket.ask({ type: "sensed_command", sense: "camera", command: { type: "move_to", x_mm, y_mm, z_mm, rotation_deg, mode, suction, gripper_deg, pause_s: 0 } });
    isTaken = !problem;
    if (problem) {
      send({ type: "look_set", set: { is_sent: false } });
      send({ type: "problem", problem });
    }
    return !problem;
  }

  /** Grips or releases at a place, from above, as a job whose title names the camera. What is placed is held until it is there. @param {string} title @param {boolean} picks @param {{ x_mm: number, y_mm: number, turn_deg?: number }} place @param {number} height_mm */
  async function transfer(title, picks, { x_mm, y_mm, turn_deg = 0 }, height_mm) {
    const arm = store.page.station?.arm;
    const paper_mm = paperHeight(store.page, { x_mm, y_mm });
    if (!arm || paper_mm === null) return false;
    socket.takeControlIfFree();
    const go = (/** @type {number} */ above_mm, /** @type {"movj" | "movl"} */ mode, /** @type {boolean} */ suction, pause_s = 0) =>
      ({ type: "move_to", x_mm, y_mm, z_mm: paper_mm + height_mm + above_mm, rotation_deg: turn_deg, mode, suction, gripper_deg: arm.gripper_deg, pause_s });
    const commands = [go(APPROACH_MM, "movj", !picks), go(0, "movl", picks, SETTLE_S), go(APPROACH_MM, "movl", picks)];
    const { job, problem } = await jobs.run("api/v1/jobs", { title, kind: "program", commands });
    if (problem) send({ type: "problem", problem });
    return job !== undefined;
  }

  return {
    video, open,
    /** The sheet lies where it belongs. */
    settled: () => worker?.postMessage({ forget: true }),
    /** Moves above a place of the picture. @param {{ x_mm: number, y_mm: number }} spot */
    async above(spot) {
      send({ type: "look_set", set: { spot, selected: null, is_above: false } });
      if (await move(spot, ABOVE_MM + heightThere(store.page.look), "movj")) send({ type: "look_set", set: { is_above: true } });
    },
    /** Lowers the tool to the spot. */
    async down() {
      const { spot } = store.page.look;
      if (spot && (await move(spot, heightThere(store.page.look), "movl"))) send({ type: "look_set", set: { is_above: false } });
    },
    /** @param {string} name */
    async pick(name) {
      const thing = thingsOf(store.page.look).find((it) => it.name === name);
      if (!thing || thing.height_mm === null || transferBlockedReason(store.page)) return;
      if (await transfer(`camera: pick up ${name}`, true, thing, thing.height_mm)) send({ type: "look_set", set: { held: name, selected: null } });
    },
    /** Puts what is held down at the spot. */
    async place() {
      const { spot, held } = store.page.look;
      if (!spot || !held || transferBlockedReason(store.page)) return;
      if (await transfer(`camera: put ${held} down`, false, spot, heightThere(store.page.look))) send({ type: "look_set", set: { held: null, is_above: false } });
    },
  };
}

/** How far above the paper the tool is when it, or the object that it holds, touches what was clicked. @param {import("../state/look.js").Look} look */
const heightThere = ({ held, heights, surface_mm }) => surface_mm + (held ? (heights[held] ?? 0) : 0);
