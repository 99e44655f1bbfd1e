// The board of a fleet of three stations, each with an arm of its own, as a teacher has it.
import assert from "node:assert/strict";
import { once } from "node:events";
import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { serveFromDisk, takeAndMove } from "./bench.mjs";
import { launch, leave, visitor } from "./browser.mjs";
import { end, start, startRouter } from "./program.mjs";

const AXE = await readFile(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
const GROUPS = { "desk-1": "room-1", "desk-2": "room-1", "desk-3": "room-2" };

let folder, router, browser, page, token;
/** The tokens of students at desk-2; that of a class is for several of them. */
const students = {};
/** The stations that run: their child processes and where they are. */
const stations = new Map();
const errors = [];

/** A port that is free now: the stations of this test meet there, and no others of this machine. */
async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  server.close();
  return port;
}

async function beginStation(name, at, data = name) {
  const words = ["up", "--fleet", "--connect", at, "--virtual", "--name", name, "--group", GROUPS[name], "--http", "127.0.0.1:0", "--raw", "off", "--data", join(folder, data), ...(name === "desk-1" ? ["--virtual-arms", "2"] : [])];
  const { child, found } = await start(words, /page +(http:\S+)/);
  return { child, url: found.replace(/\/?$/, "/") };
}

before(async () => {
  folder = await mkdtemp(join(tmpdir(), "dobot-fleet-"));
  const at = `quic/127.0.0.1:${await freePort()}`;
  router = { at, ...(await startRouter(["--listen", at])) };
  // The teacher has one token for all stations.
  const file = join(folder, "teacher");
  for (const name of [...Object.keys(GROUPS), "another"]) {
    const words = ["token", "add", "admin", "teacher", "--data", join(folder, name), ...(token ? ["--same-as", file] : [])];
    const { stdout } = await promisify(execFile)(process.env.DOBOT ?? "dobot", words);
    token ??= stdout.trim();
    await writeFile(file, token);
  }
  for (const [name, ...more] of [["Anna"], ["Ben"], ["class", "--shared"]]) {
    const { stdout } = await promisify(execFile)(process.env.DOBOT ?? "dobot", ["token", "add", "control", name, ...more, "--data", join(folder, "desk-2")]);
    students[name] = stdout.trim();
  }
  for (const name of Object.keys(GROUPS)) stations.set(name, await beginStation(name, at));
  browser = await launch();
  page = await visit("desk-1", "fleet");
});
after(async () => {
  if (browser) await leave(browser);
  for (const { child } of stations.values()) await end(child, "SIGKILL");
  if (router) await end(router.child, "SIGKILL");
  await rm(folder, { recursive: true });
  assert.deepEqual(errors, []);
});

/** A page of a station, in a window of its own. */
async function visit(name, path = "") {
  const { url } = stations.get(name);
  const context = await visitor(browser, { viewport: { width: 1440, height: 900 } });
  await serveFromDisk(context, url);
  const opened = await context.newPage();
  opened.on("pageerror", (error) => errors.push(error));
  await opened.goto(`${url}${path}`);
  return opened;
}

const ask = async (name, path, body, headers = {}) => {
  const how = body === undefined ? {} : { method: "POST", headers: { "content-type": "application/json", ...headers }, body: JSON.stringify(body) };
  return (await fetch(new URL(path, stations.get(name).url), how)).json();
};
const tile = (name) => `.tile[data-member=${name}]`;
const picture = (name) => page.$eval(`${tile(name)} canvas`, (it) => it.toDataURL());

/** Waits until what a station answers is so. */
async function waitForAnswer(name, path, isSo) {
  for (let tries = 0; tries < 600; tries += 1) {
    const answer = await ask(name, path);
    if (isSo(answer)) return answer;
    await page.waitForTimeout(50);
  }
  throw new Error(`${path} of ${name} never answers what was waited for: ${isSo}`);
}

/** Takes control of a station and holds a jog button, as its page does, until it is let go of. */
async function hold(name, axis) {
  const { token } = await ask(name, "api/v1/lease", { name: "Anna" });
  let held = true;
  const again = (async () => {
    while (held) {
      await ask(name, "api/v1/jog", { jog: { frame: "linear", axis, speed_percent: 50 } }, { "dobot-lease": token });
      await page.evaluate(() => new Promise(requestAnimationFrame));
    }
  })();
  return async () => {
    held = false;
    await again;
    await fetch(new URL("api/v1/lease", stations.get(name).url), { method: "DELETE", headers: { "dobot-lease": token } });
  };
}

/** What is wrong on a page for a screen reader and people who see little, by rule and place. */
async function violations(opened) {
  await opened.evaluate(AXE);
  const { violations } = await opened.evaluate(() => window.axe.run());
  return violations.map(({ id, nodes }) => `${id}: ${nodes.map((it) => it.target.join(" ")).join(", ")}`);
}

/** The packets to the arm of a station, from now on. */
async function listen(name) {
  const ending = new AbortController(), packets = [];
  const answer = await fetch(new URL("api/v1/packets", stations.get(name).url), { signal: ending.signal });
  (async () => {
    let text = "";
    for await (const piece of answer.body.pipeThrough(new TextDecoderStream())) {
      const blocks = (text + piece).split("\n\n");
      text = blocks.pop();
      for (const block of blocks) {
        const data = block.match(/^data: (.*)$/m);
        if (data && block.includes("event: packet")) packets.push(JSON.parse(data[1]));
      }
    }
  })().catch(() => {});
  return { packets, end: () => ending.abort() };
}

test("each station of the fleet has a tile, in the section of its group, with its name and lease holder", async () => {
  for (const name of stations.keys()) await page.waitForSelector(`${tile(name)}[data-presence=present]`);
  const sections = await page.$$eval("section.group", (all) => all.map((it) => [it.querySelector("[data-stop-group]").dataset.stopGroup, [...it.querySelectorAll(".name")].map((name) => name.textContent)]));
  assert.deepEqual(sections, [["room-1", ["desk-1", "desk-2"]], ["room-2", ["desk-3"]]]);
  assert.equal(await page.textContent("#count .chip"), "3 of 3 online");
  assert.equal(await page.textContent(`${tile("desk-2")} .who`), "nobody has control");
});

test("a jog is shown on the tile of its arm alone, and STOP ALL stops every arm while the button is held", async () => {
  await page.click(`${tile("desk-2")} .name`);
  await page.waitForSelector("#details-title");
  const [before, other] = [await picture("desk-2"), await picture("desk-3")];
  const traffic = await listen("desk-2");
  const release = await hold("desk-2", "y_plus");
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-2] .who").textContent === "Anna");
  await page.waitForFunction((before) => document.querySelector(".tile[data-member=desk-2] canvas").toDataURL() !== before, before);
  assert.equal(await picture("desk-3"), other);
  await waitForAnswer("desk-2", "api/v1/state", ({ arm }) => arm.y_mm > 5);

  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("3 of 3 stopped."));
  for (const name of stations.keys()) {
    const { stop } = await ask(name, "api/v1/state");
    assert.equal(stop.reason, "pressed on the board of desk-1", name);
    await page.waitForSelector(`${tile(name)}[data-tone=bad]`);
    await page.waitForFunction((name) => document.querySelector(`.tile[data-member=${name}] .alarms`).textContent.includes("stopped"), name);
  }
  // The button is held on: it moves nothing any more.
  await waitForAnswer("desk-2", "api/v1/state", ({ stop }) => stop.at_rest);
  const { arm: { y_mm } } = await ask("desk-2", "api/v1/state");
  await release();
  assert.equal((await ask("desk-2", "api/v1/state")).arm.y_mm, y_mm);
  // What the arm was told last of buttons is that they are let go.
  const jogs = traffic.packets.map(({ command }) => command).filter((it) => it?.type === "linear_jog");
  assert.ok(jogs.some(({ axis }) => axis === "y_plus"));
  assert.equal(jogs.at(-1).axis, "released", JSON.stringify(jogs.slice(-3)));
  traffic.end();
});

test("without a token the other stations allow only watching and stopping, and the board shows that and asks for one", async () => {
  await page.click("#details-reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#denied");
  assert.match(await page.textContent("#outcome"), /0 of 1 stops cleared\.\s*desk-2: Your token does not allow this: role control is required/);
  assert.notEqual((await ask("desk-2", "api/v1/state")).stop, null);
  await page.fill("#token-field", token);
  await page.click("#token button");
  await page.waitForSelector("#denied", { state: "detached" });
});

test("a person resets the stops, one by one or all, after a question", async () => {
  await page.click("#details-reset");
  assert.match(await page.textContent("#confirm-text"), /^desk-2: look at each arm first/);
  await page.click("#confirm-yes");
  await waitForAnswer("desk-2", "api/v1/state", ({ stop }) => stop === null);
  assert.notEqual((await ask("desk-3", "api/v1/state")).stop, null);
  await page.waitForFunction(() => document.querySelector("#reset")?.textContent === "Clear stops (2)…");
  await page.click("#reset");
  await page.click("#confirm-yes");
  for (const name of stations.keys()) await waitForAnswer(name, "api/v1/state", ({ stop }) => stop === null);
});

test("a person without an arm gets a virtual one, moves it on its own page, and it leaves the board when it is ended", async () => {
  await page.click("#arm-open");
  await page.fill("#arm-name", " Zoë B. ");
  await page.click("#arm-give");
  await page.waitForSelector("#arm-page");
  const at = await page.getAttribute("#arm-page", "href");
  await page.waitForSelector(`${tile("zoe-b")}[data-presence=present]`);
  const context = await visitor(browser, { viewport: { width: 1440, height: 900 } });
  const own = await context.newPage();
  own.on("pageerror", (error) => errors.push(error));
  await own.goto(at);
  await takeAndMove(own);
  await page.waitForFunction(() => document.querySelector(".tile[data-member=zoe-b] .who")?.textContent !== "nobody has control");
  // One who is named as an arm that is there already is told so, and gets another name.
  await page.fill("#arm-name", "desk-2");
  await page.click("#arm-give");
  await page.waitForFunction(() => /Another station has this name/.test(document.querySelector("#outcome").textContent));
  await page.click("#outcome-close");
  await page.click("#arm-open");
  await page.click(`${tile("zoe-b")} .name`);
  await page.waitForFunction(() => /Host\s*desk-1/.test(document.querySelector("#details").textContent));
  await page.click("#details-end-arm");
  await page.click("#confirm-yes");
  await page.waitForSelector(tile("zoe-b"), { state: "detached" });
  await page.click(`${tile("desk-2")} .name`);
  await context.close();
});

test("Escape stops all, and the button of a group stops its arms alone", async () => {
  await page.click("[data-stop-group=room-2]");
  await waitForAnswer("desk-3", "api/v1/state", ({ stop }) => stop !== null);
  assert.equal((await ask("desk-1", "api/v1/state")).stop, null);
  await page.keyboard.press("Escape");
  for (const name of stations.keys()) await waitForAnswer(name, "api/v1/state", ({ stop }) => stop !== null);
  await page.waitForFunction(() => document.querySelector("#reset")?.textContent === "Clear stops (3)…");
  await page.click("#reset");
  await page.click("#confirm-yes");
  for (const name of stations.keys()) await waitForAnswer(name, "api/v1/state", ({ stop }) => stop === null);
});

test("the job of an arm is on its tile, and it is paused, resumed and cancelled from the board", async () => {
  const there = { type: "move_to", x_mm: 200, y_mm: -80, z_mm: 30, rotation_deg: 0, suction: false, mode: "movj", gripper_deg: 0, pause_s: 0.5 };
  const back = { ...there, y_mm: 80 };
  await ask("desk-2", "api/v1/jobs", { title: "there and back", kind: "program", commands: Array.from({ length: 40 }, (_, n) => (n % 2 ? back : there)) });
  await page.waitForSelector("#details [data-act=start]:enabled");
  await page.click("#details [data-act=start]");
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-2] .job .title")?.textContent === "there and back");
  // Control is given back at once: Anna can take it while the job runs.
  await waitForAnswer("desk-2", "api/v1/state", ({ job, lease }) => job?.phase === "running" && lease === null);
  await page.click("#details [data-act=pause]");
  await waitForAnswer("desk-2", "api/v1/state", ({ job }) => job?.phase === "paused");
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-2] .alarms").textContent.includes("paused"));
  await page.click("#details [data-act=end]");
  await waitForAnswer("desk-2", "api/v1/state", ({ job }) => job === null);
});

test("eyes on me holds every arm, and its own page shows who and why; a message appears there too", async () => {
  const own = await visit("desk-2");
  await page.fill("#lesson-text", "eyes on me");
  await page.click("#lock");
  for (const name of stations.keys()) await waitForAnswer(name, "api/v1/state", ({ lock }) => lock?.message === "eyes on me");
  await own.waitForSelector("#locked");
  assert.equal((await own.textContent("#locked")).trim(), "The arm is locked. By teacher: eyes on me.");
  await page.waitForFunction(() => [...document.querySelectorAll(".tile .alarms")].every((it) => it.textContent.includes("locked")));
  await page.fill("#lesson-text", "Five minutes");
  await page.click("#send");
  await own.waitForSelector("#message");
  assert.match(await own.textContent("#message p"), /teacher.*Five minutes/);
  await page.click("#release");
  for (const name of stations.keys()) await waitForAnswer(name, "api/v1/state", ({ lock }) => !lock);
  await own.waitForSelector("#locked", { state: "detached" });
  await own.context().close();
});

test("in a time slot only its student has the arm, the others see the student and the end, and a client with a shared token can say who it is", async () => {
  await page.fill("#slots-arm [name=names]", "Anna\nChen");
  await page.click("#slots-arm [type=submit]");
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-2] .who").textContent.startsWith("Anna: 1"));
  await page.waitForFunction(() => document.querySelectorAll("#details ol.slots li").length === 2);
  const [anna, ben, mate] = await Promise.all(["Anna", "Ben", "class"].map((name) => visit("desk-2", `#token=${students[name]}`)));
  for (const it of [ben, mate]) {
    await it.waitForSelector("#slot");
    assert.match(await it.textContent("#slot"), /This is the time slot of Anna\.\s+1\d min \d\d s left\. The arm is free in (29|30) min/);
    assert.equal(await it.textContent("#holder"), "Not your time slot: nobody has control");
    assert.equal(await it.locator("#take, #ask").count(), 0, "no button that leads nowhere");
    assert.equal(await it.isDisabled("[data-axis=x_plus]"), true);
  }
  assert.equal(await ben.locator("#slot-me").count(), 0, "his token says that he is Ben");
  await mate.setViewportSize({ width: 360, height: 740 });
  await mate.emulateMedia({ colorScheme: "dark" });
  for (const it of [ben, mate]) assert.deepEqual(await violations(it), []);
  assert.equal(await mate.evaluate(() => document.documentElement.scrollWidth), 360);
  await anna.waitForSelector("#slot[data-tone=good]");
  assert.match(await anna.textContent("#slot"), /This is your time slot\.\s+1\d min \d\d s left\. Next: Chen\./);
  await anna.click("#take");
  await anna.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await anna.click("#release");
  await mate.click("#slot-me");
  await mate.waitForSelector("#slot[data-tone=good]");
  await mate.click("#take");
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-2] .who").textContent.startsWith("Anna: 1"));
  const { lease } = await ask("desk-2", "api/v1/state");
  assert.equal(lease.name, "Anna");

  // The next one is Ben: whoever has control loses it at once, and he has the arm.
  await page.fill("#slots-arm [name=names]", "Ben");
  await page.click("#slots-arm [type=submit]");
  await waitForAnswer("desk-2", "api/v1/state", ({ lease, slots }) => lease === null && slots.now.student === "Ben");
  await ben.click("#take");
  await ben.waitForFunction(() => document.querySelector("#holder").textContent === "You have control.");
  await mate.waitForSelector("#slot[data-tone=warn]");
  await page.click("#details [data-act=clear]");
  await mate.waitForSelector("#slot", { state: "detached" });
  await ben.click("#release");
  for (const it of [anna, ben, mate]) await it.context().close();
});

test("a student in a lesson enters a name once, and the board shows the lesson and the step", async () => {
  const own = await visit("desk-2");
  await own.waitForSelector("#fleet");
  await own.click("#first-tour");
  await own.fill("#lesson-who input", "Anna");
  await own.click("#lesson-who button");
  await own.waitForSelector("#lesson-student");
  const line = (text) => page.waitForFunction((text) => document.querySelector(".tile[data-member=desk-2] .learner")?.textContent.includes(text), text);
  await line("step 1 of 12");
  assert.match(await page.textContent(`${tile("desk-2")} .learner`), /^Anna .*Tour/);
  await own.click("#lesson-next");
  await line("step 2 of 12");
  await own.reload();
  await own.click("#tab-set_up");
  await own.click("#lessons-open");
  await own.click("[data-lesson=kinematics]");
  await own.waitForSelector("#lesson-student");
  await line("Inverse kinematics by hand");
  await own.context().close();
});

test("the drawing of an arm is saved as a picture", async () => {
  const saving = page.waitForEvent("download");
  await page.click("#details-drawing");
  const saved = await saving;
  assert.equal(saved.suggestedFilename(), "desk-2.svg");
});

test("a second station of the same name is reported on both tiles, and a stop reaches both", async () => {
  const twin = await beginStation("desk-2", router.at, "another");
  stations.set("another", twin);
  await page.waitForFunction(() => [...document.querySelectorAll(".tile[data-member=desk-2] .why")].filter((it) => it.textContent.startsWith("No requests are sent to this station: 2 stations use the name desk-2.")).length === 2);
  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("4 of 4 stopped."));
  assert.notEqual((await ask("another", "api/v1/state")).stop, null);
  await end(twin.child, "SIGINT");
  stations.delete("another");
  await page.waitForFunction(() => document.querySelectorAll(".tile[data-member=desk-2][data-presence=present]").length === 1);
});

test("without the router the others are away, the arm of the board still stops, and all return with the router", async () => {
  await end(router.child, "SIGKILL");
  for (const name of ["desk-2", "desk-3"]) await page.waitForSelector(`${tile(name)}[data-presence=away]`);
  for (const name of stations.keys()) await fetch(new URL("api/v1/stop", stations.get(name).url), { method: "DELETE" });
  await waitForAnswer("desk-1", "api/v1/state", ({ stop }) => stop === null);
  await page.click("#stop");
  await waitForAnswer("desk-1", "api/v1/state", ({ stop }) => stop !== null);
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("NO ANSWER from"));
  assert.match(await page.textContent("#stop-status"), /1 of \d stopped\./);
  router.child = (await startRouter(["--listen", router.at])).child;
  for (const name of ["desk-2", "desk-3"]) await page.waitForSelector(`${tile(name)}[data-presence=present]`);
});

test("a killed station is grey, and a stop reports that it did not answer", async () => {
  const { child, url } = stations.get("desk-3");
  await end(child, "SIGKILL");
  stations.delete("desk-3");
  await page.waitForSelector(`${tile("desk-3")}[data-presence=away]`);
  await page.waitForFunction(() => document.querySelector(".tile[data-member=desk-3] .why").textContent === "Stop it on its own page");
  await page.click("#stop");
  await page.waitForFunction(() => /2 of \d stopped\./.test(document.querySelector("#stop-status").textContent));
  const text = await page.textContent("#stop-status");
  assert.match(text, /NO ANSWER from .*desk-3.*: press STOP on their own pages\./);
  assert.equal(new URL(await page.getAttribute(`${tile("desk-3")} .why a`, "href")).port, new URL(url).port);
});

test("the page of a station links to the board", async () => {
  const own = await visit("desk-1");
  await own.click("#fleet");
  await own.waitForSelector(".tile");
  await own.context().close();
});

test("a board without its station shows the age of its data, and continues with the next station", async () => {
  const { child } = stations.get("desk-1");
  await end(child, "SIGKILL");
  stations.delete("desk-1");
  await page.waitForSelector("#lost");
  assert.match(await page.textContent("#lost"), /NO CONNECTION to the station of this board/);
  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("STOP NOT CONFIRMED by any other station."));
  assert.ok(await page.$(`#stop-status a[href^="${new URL(stations.get("desk-2").url).origin}"]`));
});
