// A class with its board: three stations in three networks, a router between them that is killed, and a browser in the network of the
// teacher and in that of a student. `tests/fleet/board.sh` makes the networks and starts this.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdir, writeFile } from "node:fs/promises";
import { resolve } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { takeAndMove } from "./bench.mjs";
import { launch, visitor } from "./browser.mjs";
import { end, start, startRouter } from "./program.mjs";

const PAGE = "http://127.0.0.1:8642/";
/** The teacher's station, which gives virtual arms, a student's, who has pen and paper, and one that students share in time slots. */
const DESKS = {
  "desk-1": ["--virtual-arms", "5"],
  "desk-2": ["--group", "room-2", "--offers", "pen", "--offers", "a5", "--takes-work=start"],
  "desk-3": ["--group", "room-2", "--token-required"],
};
/** However slow the machine is. */
const PATIENCE_MS = 180_000;

let router, token, board, student;
/** The tokens of those who share desk-3. */
const students = {};
const stations = new Map(), browsers = [], errors = [];

const inside = (network) => ["ip", "netns", "exec", network];
const beginRouter = async () => (await startRouter(["--listen", "quic/0.0.0.0:7447", "--fleet=keys/router"], inside("router"))).child;

async function beginDesk(name, number) {
  const words = ["up", "--virtual", "--raw", "off", "--no-open", "--data", resolve(name), "--name", name, `--fleet=keys/${name}`, "--connect", `quic/10.7.${number}.1:7447`, ...DESKS[name]];
  return (await start(words, /page +(http:\S+)/, inside(name))).child;
}

/** One token of the teacher, accepted at each desk. */
async function addToken(name) {
  const words = ["token", "add", "admin", "teacher", "--data", resolve(name), ...(token ? ["--same-as", resolve("teacher")] : [])];
  const { stdout } = await promisify(execFile)(process.env.DOBOT, words);
  token ??= stdout.trim();
  await writeFile("teacher", token);
}

/** A token of a student at desk-3. */
async function addStudent(name) {
  const { stdout } = await promisify(execFile)(process.env.DOBOT, ["token", "add", "control", name, "--data", resolve("desk-3")]);
  students[name] = stdout.trim();
}

/** A page in a browser that runs in the network of a desk. */
async function visit(network, path) {
  const script = resolve(`${network}.sh`);
  await writeFile(script, `#!/bin/sh\nexec ${inside(network).join(" ")} "${process.env.CHROMIUM}" "$@"\n`, { mode: 0o755 });
  const browser = await launch(script);
  browsers.push(browser);
  const page = await (await visitor(browser, { viewport: { width: 1440, height: 900 } })).newPage();
  page.setDefaultTimeout(PATIENCE_MS);
  page.on("pageerror", (error) => errors.push(error));
  await page.goto(`${PAGE}${path}`);
  return page;
}

before(async () => {
  for (const name of Object.keys(DESKS)) {
    await mkdir(name);
    await addToken(name);
  }
  for (const name of ["Anna", "Ben"]) await addStudent(name);
  router = await beginRouter();
  for (const [n, name] of Object.keys(DESKS).entries()) stations.set(name, await beginDesk(name, n + 1));
  board = await visit("desk-1", `fleet#token=${token}`);
  student = await visit("desk-2", "");
});
after(async () => {
  for (const browser of browsers) await browser.close();
  for (const child of stations.values()) await end(child, "SIGKILL");
  if (router) await end(router, "SIGKILL");
  assert.deepEqual(errors, []);
});

const tile = (name) => `.tile[data-member=${name}]`;
/** Waits until the state of the station of a page is so. */
const state = (page, isSo) => page.waitForFunction(async (isSo) => new Function(`return ${isSo}`)()(await (await fetch("api/v1/state")).json()), isSo.toString(), { polling: 200 });
const waitForText = (selector, text) => board.waitForFunction(([selector, text]) => document.querySelector(selector)?.textContent.includes(text), [selector, text]);
const seen = async (presence) => { for (const name of ["desk-2", "desk-3"]) await board.waitForSelector(`${tile(name)}[data-presence=${presence}]`); };
/** The entry of the queue with this title. */
const entry = (title) => `#queue [data-work]:has(.title:text-is("${title}"))`;

/** Submits a text with a student's name. */
async function submit(text, name) {
  await board.check("[name=submit-what][value=text]", { force: true });
  await board.fill("#submit-text", text);
  await board.fill("#submit-student", name);
  await board.click("#submit-send");
  await board.waitForSelector(entry(text));
}

test("the board shows each station of the three networks", async () => {
  await seen("present");
  await waitForText("#count .chip", "3 of 3 online");
});

test("a drawing that is submitted at the board is taken by the arm that has what it needs, and drawn", async () => {
  await board.click("#queue-open");
  await board.check("#submit-needs [value=a5]");
  await waitForText("#submit-arms", "desk-2");
  await board.fill("#submit-down", "-40");
  await submit("i", "Anna");
  await board.waitForSelector(`${entry("i")}[data-phase=done]`);
  assert.match(await board.textContent(`${entry("i")} .where`), /^desk-2: job \d+, done$/);
  const jobs = await student.evaluate(async () => (await fetch("api/v1/jobs")).json());
  assert.deepEqual(jobs.map(({ title, phase }) => [title, phase]), [["i (Anna)", "done"]]);
});

test("eyes on me holds each arm and shows on the student's page, a message too; release lets go", async () => {
  await board.fill("#lesson-text", "eyes on me");
  await board.click("#lock");
  await waitForText("#outcome", "3 of 3 locked.");
  await student.waitForSelector("#locked");
  assert.equal((await student.textContent("#locked")).trim(), "The arm is locked. By teacher: eyes on me.");
  await board.fill("#lesson-text", "Five minutes");
  await board.click("#send");
  await student.waitForSelector("#message");
  assert.match(await student.textContent("#message p"), /teacher.*Five minutes/);
  await board.click("#release");
  await state(student, ({ lock }) => !lock);
});

test("whoever has no arm is given a virtual one by the board, and moves it on a page of its own", async () => {
  await board.click("#arm-open");
  await board.fill("#arm-name", "Chen");
  await board.click("#arm-give");
  await board.waitForSelector(`${tile("chen")}[data-presence=present]`);
  await waitForText("#count .chip", "4 of 4 online");
  const own = await board.context().newPage();
  await own.goto(await board.getAttribute("#arm-page", "href"));
  await takeAndMove(own);
  await own.close();
  await board.click("#arm-open");
  await board.click(`${tile("chen")} .name`);
  await board.click("#details-end-arm");
  await board.click("#confirm-yes");
  await board.waitForSelector(tile("chen"), { state: "detached" });
});

test("in the time slot of a student nobody else moves the arm of the desk, and a slot ends when the teacher says so", async () => {
  await board.click(`${tile("desk-3")} .name`);
  await board.fill("#slots-arm [name=names]", "Anna\nBen");
  await board.click("#slots-arm [type=submit]");
  await waitForText(`${tile("desk-3")} .who`, "Anna: ");
  const [anna, ben] = await Promise.all(["Anna", "Ben"].map((name) => visit("desk-3", `#token=${students[name]}`)));
  await anna.waitForSelector("#slot[data-tone=good]");
  await takeAndMove(anna);
  await ben.waitForSelector("#slot");
  assert.equal(await ben.locator("#take, #ask").count(), 0, "no button that leads nowhere");
  // Nor does it help him to ask as a program does.
  const asked = await ben.evaluate(async (token) => (await fetch("api/v1/lease", { method: "POST", headers: { authorization: `Bearer ${token}` } })).status, students.Ben);
  assert.equal(asked, 409);
  await board.click("#details [data-act=clear]");
  await ben.waitForSelector("#slot", { state: "detached" });
  await board.click(`${tile("desk-3")} .name`);
  for (const it of [anna, ben]) await it.context().browser().close();
});

test("a student who takes a lesson is on the board with the step", async () => {
  await student.waitForSelector("#fleet");
  await student.click("#first-tour");
  await student.fill("#lesson-who input", "Anna");
  await student.click("#lesson-who button");
  await waitForText(`${tile("desk-2")} .learner`, "step 1 of 12");
  await student.click("#lesson-next");
  await waitForText(`${tile("desk-2")} .learner`, "step 2 of 12");
  assert.match(await board.textContent(`${tile("desk-2")} .learner`), /^Anna /);
  await student.click("#lesson-end");
});

test("with the router killed the others are away, what they have is in doubt, and STOP ALL says who did not answer", async () => {
  await board.click("#queue-open");
  await submit("Ben", "Ben");
  await state(student, ({ job }) => job?.phase === "running");
  await board.waitForSelector(`${entry("Ben")}[data-phase=taken]`);
  await end(router, "SIGKILL");
  await seen("away");
  await board.waitForSelector(`${entry("Ben")}[data-doubtful=true]`);
  assert.match(await board.textContent(`${entry("Ben")} .status-of`), /^Desk-2 cannot be reached; \d+ of \d+ commands were done at the last report, and it may continue\.$/);
  await waitForText("#queue-open", "1 uncertain");
  await board.click("#stop");
  await waitForText("#stop-status", "1 of 3 stopped.");
  assert.match(await board.textContent("#stop-status"), /NO ANSWER from desk-2 and desk-3: press STOP on their own pages\./);
  await state(board, ({ stop }) => stop !== null);
  // The arm that nobody of the fleet reaches is stopped on its own page.
  assert.equal((await student.evaluate(async () => (await fetch("api/v1/state")).json())).stop, null);
  await student.click("#stop");
  await state(student, ({ stop }) => stop?.at_rest === true);
});

test("with the router back they find each other, the doubt ends by itself, and no other arm has drawn it", async () => {
  router = await beginRouter();
  await seen("present");
  await board.waitForSelector(`${entry("Ben")}[data-doubtful=false]`);
  assert.match(await board.textContent(`${entry("Ben")} .where`), /^desk-2: job \d+, /);
  const jobs = await board.evaluate(async () => (await fetch("api/v1/jobs")).json());
  assert.deepEqual(jobs, []);
  await board.click("#stop");
  await waitForText("#stop-status", "3 of 3 stopped.");
  // Only those that the board has heard to be stopped are asked about: each tells of itself every second.
  await waitForText("#reset", "Clear stops (3)…");
  // An arm that is not seen at rest is not let go.
  for (const page of [board, student]) await state(page, ({ stop }) => stop?.at_rest === true);
  await board.click("#reset");
  await board.click("#confirm-yes");
  await waitForText("#outcome", "3 of 3 stops cleared.");
  await state(student, ({ stop }) => stop === null);
});
