// The board with the arms of a school, on a mock station: keys, sizes, screen readers, and failures.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { after, afterEach, before, test } from "node:test";
import { launch, leave, visitor } from "./browser.mjs";
import { gesture, hand, numbers, words } from "./gestures.mjs";
import { crowd, job, learner, member, queue, mockStation, time } from "./mock_station.mjs";

const AXE = await readFile(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
const SIZES = { desktop: { width: 1440, height: 900 }, tablet: { width: 1024, height: 768 }, phone: { width: 360, height: 740 } };
const DENIED = { type: "/api/v1/problems/unauthorised", title: "this takes a token", status: 401, detail: "the station does not know this token", hint: "make one on its machine" };

let browser;
/** What a test opened. */
let opened = [];
const errors = [];

before(async () => { browser = await launch(); });
after(() => leave(browser));
afterEach(async () => {
  for (const it of opened.splice(0)) await it();
  assert.deepEqual(errors.splice(0), []);
});

/** The board of these stations, and the stand-in that tells them. */
async function open(members, { answer, submitted, ...options } = {}) {
  const station = await mockStation(members, answer, submitted);
  const context = await visitor(browser, { viewport: SIZES.desktop, reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(error));
  opened.push(() => context.close(), () => station.end());
  await page.goto(station.url);
  return { page, station };
}
const asked = (station, path) => station.asked.filter((it) => it.path === path);
/** The stops that were pressed, without those that a slow answer asked for again. */
const stops = (station) => asked(station, "/api/v1/fleet/stop").filter(({ body }) => !body.reason.endsWith("(repeated)"));
const focused = (page) => page.evaluate(() => document.activeElement.textContent);
const text = (page, selector) => page.textContent(selector).then((it) => it.replace(/\s+/g, " ").trim());

for (const [size, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ["light", "dark"]) {
    test(`axe finds nothing on a ${size} in the ${colorScheme} theme`, async () => {
      const answer = ({ path, body }) => (path === "/api/v1/fleet/requests" && body.path === "/api/v1/stop" ? { body: [{ member: "desk-7", id: "7", answer: { status: 401, body: DENIED }, took_ms: 1 }] } : undefined);
      const members = crowd(30);
      const { page } = await open(members, { viewport, colorScheme, answer, submitted: queue(members) });
      await page.waitForSelector(".tile");
      await page.evaluate(AXE);
      const look = async (what) => {
        const { violations, passes } = await page.evaluate(() => window.axe.run());
        assert.ok(passes.length > 15, "axe has looked at it");
        assert.deepEqual(violations.map(({ id, nodes }) => `${id}: ${nodes.map((it) => it.target.join(" ")).join(", ")}`), [], what);
      };
      await look("tiles");
      await page.click("#stop");
      await page.waitForSelector("#stop-status p");
      await page.click("#reset");
      await look("question");
      await page.click("#confirm-yes");
      await page.waitForSelector("#denied");
      await look("denied");
      await page.click("#outcome-close");
      await page.click("#arm-open");
      await page.waitForSelector("#arm");
      await look("virtual arm");
      await page.click("#arm-open");
      await page.click(".tile[data-member=desk-5] .name");
      await page.waitForSelector("#details-title");
      await look("details");
      await page.click("#queue-open");
      await page.waitForSelector("#queue [data-work]");
      await look("queue");
      if (size === "phone") await page.click("#lesson-open");
      await page.click("#slots-open");
      await page.waitForSelector("#slots h3");
      await look("slots");
    });
  }
}

test("on a phone nothing extends beyond the screen, and STOP ALL is the largest element, within reach of a thumb", async () => {
  const members = crowd(30);
  const { page } = await open(members, { viewport: SIZES.phone, hasTouch: true, isMobile: true, submitted: queue(members) });
  await page.waitForSelector(".tile");
  const lock = async () => {
    await page.click("#lock");
    await page.waitForSelector("#outcome[data-tone=bad]");
  };
  const queued = async () => {
    await page.click("#queue-open");
    await page.waitForSelector("#queue [data-work]");
  };
  const timed = async () => {
    await page.click("#slots-open");
    await page.waitForSelector("#slots h3");
  };
  for (const lead of [async () => {}, () => page.click("#stop"), () => page.click("#lesson-open"), lock, () => page.click(".tile[data-member=desk-1] .name"), queued, timed]) {
    await lead();
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), SIZES.phone.width);
    const stop = await page.locator("#stop").boundingBox();
    assert.ok(stop.y > SIZES.phone.height / 2 && stop.y + stop.height <= SIZES.phone.height && stop.width > 300, JSON.stringify(stop));
    const areas = await page.$$eval("button", (all) => all.map((it) => [it.id, it.offsetWidth * it.offsetHeight]).sort((a, b) => b[1] - a[1]));
    assert.equal(areas[0][0], "stop");
    // Nothing lies over it.
    const low = [stop.x + stop.width / 2, stop.y + stop.height - 8];
    await page.waitForFunction(([x, y]) => document.elementFromPoint(x, y)?.closest("button")?.id === "stop", low);
  }
});

test("arrow keys move from tile to tile, Enter opens one, and Escape stops all from anywhere", async () => {
  const { page, station } = await open(crowd(30));
  await page.waitForSelector(".tile");
  await page.focus(".tile .name[tabindex='0']");
  assert.equal(await focused(page), "desk-1");
  await page.keyboard.press("ArrowRight");
  assert.equal(await focused(page), "desk-2");
  const [below, now] = await page.evaluate(() => {
    const boxes = [...document.querySelectorAll(".tile .name")].map((it) => [it.textContent, it.getBoundingClientRect()]);
    const here = boxes.find(([name]) => name === "desk-2")[1];
    return [boxes.find(([, box]) => box.top > here.bottom && Math.abs(box.left - here.left) < 5)[0], "desk-2"];
  });
  await page.keyboard.press("ArrowDown");
  assert.equal(await focused(page), below);
  await page.keyboard.press("ArrowUp");
  assert.equal(await focused(page), now);
  // One tile is in the order of the tab key, with its own stop behind it.
  assert.equal(await page.locator(".tile .name[tabindex='0']").count(), 1);
  await page.waitForSelector(".tile[data-member=desk-2] .one[tabindex='0']");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute("aria-label")), "STOP desk-2");
  await page.keyboard.press("Shift+Tab");
  await page.keyboard.press("Enter");
  assert.equal(await text(page, "#details-title"), "desk-2");
  await page.focus("#filter");
  await page.keyboard.press("Escape");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("30 stopped"));
  assert.deepEqual(stops(station).map(({ body }) => body.to), ["all"]);
});

test("each STOP of the board acts on the press of a mouse and of a finger that moves, slides off, or is not the only one", async () => {
  const { page, station } = await open(crowd(3), { viewport: SIZES.tablet, hasTouch: true });
  await page.click(".tile[data-member=desk-2] .name");
  const fingers = await hand(page);
  const random = numbers(1);
  const buttons = { "#stop": "all", "[data-stop-group=room-1]": { group: "room-1" }, ".tile[data-member=desk-3] .one": { members: ["desk-3"] }, "#details-stop": { members: ["desk-2"] } };
  for (let n = 0; n < 40; n += 1) {
    const [selector, to] = Object.entries(buttons)[n % 4];
    // The smaller buttons have no room for a flat hand.
    const it = { ...gesture(random, ["#details-title"]), ...(n % 4 && { fingers: 1 }) };
    const before = stops(station).length;
    const acted = async () => {
      for (const until = performance.now() + 10_000; stops(station).length === before && performance.now() < until;) await page.evaluate(() => new Promise(requestAnimationFrame));
    };
    await fingers.press(selector, it, it.rests ? await fingers.rest(it.rests) : [], acted);
    await page.waitForSelector("#stop-status p");
    assert.deepEqual(stops(station).slice(before).map(({ body }) => body.to), Array(it.by === "mouse" ? 1 : it.fingers).fill(to), `${selector}: ${words(it)}`);
  }
});

test("a station that did not answer a stop is shown with a link to its page, and a second press asks again", async () => {
  const members = [member("desk-1", { here: true }), member("desk-3", { presence: { type: "away" }, page: "http://desk-3.lab:8642/" }), member("desk-7", { presence: { type: "away" }, page: "javascript:alert(1)" })];
  const { page, station } = await open(members);
  await page.waitForSelector(".tile");
  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("1 of 3 stopped."));
  assert.match(await text(page, "#stop-status"), /1 of 3 stopped\. NO ANSWER from desk-3 and desk-7: press STOP on their own pages\. Page of desk-3/);
  // What a station tells of itself leads nowhere but to a page.
  assert.deepEqual(await page.$$eval("a[href^='javascript']", (all) => all.length), 0);
  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("1 of 3 stopped."));
  assert.equal(stops(station).length, 2);
});

test("an unknown token prevents no stop", async () => {
  const answer = ({ token, path }) => (token === "wrong" && path === "/api/v1/fleet/stop" ? { status: 401, body: DENIED } : undefined);
  const { page, station } = await open([member("desk-1", { here: true })], { answer });
  await page.waitForSelector(".tile");
  await page.evaluate(() => sessionStorage.setItem("token", "wrong"));
  await page.keyboard.press("Space");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("1 of 1 stopped."));
  assert.deepEqual(stops(station).map(({ token }) => token), ["wrong", null]);
});

test("if the fleet cannot be reached, at least the arm of this station is stopped", async () => {
  const ending = { type: "/api/v1/problems/ending", title: "the station is shutting down", status: 503, detail: "the station leaves its fleet" };
  const answer = ({ path }) => (path === "/api/v1/fleet/stop" ? { status: 503, body: ending } : undefined);
  const { page, station } = await open([member("desk-1", { here: true })], { answer });
  await page.waitForSelector(".tile");
  const stopped = page.waitForResponse((it) => new URL(it.url()).pathname === "/api/v1/stop");
  await page.click("#stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("the station leaves its fleet."));
  await stopped;
  assert.equal(asked(station, "/api/v1/stop").length, 1);
});

test("an unanswered STOP is shown in red, sent again, and stops the arm of this station over another connection", async () => {
  const { page } = await open([member("desk-1", { here: true })]);
  await page.waitForSelector(".tile");
  await page.route("**/api/v1/fleet/stop", () => {});
  const stopped = page.waitForResponse((it) => new URL(it.url()).pathname === "/api/v1/stop");
  await page.click("#stop");
  await stopped;
  await page.waitForFunction(() => document.querySelector("#stop-status[data-tone=bad]")?.textContent.includes("Switch the arms off"));
  await page.unroute("**/api/v1/fleet/stop");
  await page.waitForFunction(() => document.querySelector("#stop-status").textContent.includes("1 of 1 stopped."));
});

test("a station that requires a token is shown in its own words, and the given token is sent along", async () => {
  const answer = ({ token, path }) => (token === "secret" || !path.startsWith("/api/v1/fleet") ? undefined : { status: 401, body: DENIED });
  const { page, station } = await open([member("desk-1", { here: true })], { answer });
  await page.waitForSelector("#denied");
  assert.equal(await text(page, "#denied label"), "The station needs an access token: the station does not know this token. Make one on its machine.");
  await page.fill("#token-field", "secret");
  await page.click("#token button");
  await page.waitForSelector(".tile");
  await page.waitForSelector("#denied", { state: "detached" });
  assert.equal(station.asked.at(-1).token, "secret");
});

test("eyes on me and a message go to the displayed group, or to all", async () => {
  const { page, station } = await open([member("desk-1", { here: true, groups: ["room-1"] }), member("desk-2", { groups: ["room-2"], lock: { by: "Ms Lee", message: "eyes on me", at_s: 3 } })]);
  await page.waitForSelector(".tile");
  const requests = () => asked(station, "/api/v1/fleet/requests").map(({ body }) => body);
  await page.click("#lock");
  await page.waitForFunction(() => document.querySelector("#outcome")?.textContent.includes("2 of 2 locked."));
  assert.deepEqual(requests().at(-1), { to: "all", method: "POST", path: "/api/v1/lock", body: { message: "Eyes on me" } });
  await page.selectOption("#group", "room-2");
  await page.fill("#lesson-text", "Five minutes");
  await page.click("#send");
  await page.waitForFunction(() => document.querySelector("#outcome").textContent.includes("Sent to 1 of 1."));
  assert.deepEqual(requests().at(-1), { to: { group: "room-2" }, method: "POST", path: "/api/v1/message", body: { text: "Five minutes" } });
  await page.waitForFunction(() => document.querySelector("#lesson-text").value === "");
  assert.match(await page.textContent(".tile[data-member=desk-2] .alarms"), /locked/);
  await page.click("#release");
  await page.waitForFunction(() => document.querySelector("#outcome").textContent.includes("1 of 1 unlocked."));
  assert.deepEqual(requests().at(-1), { to: { group: "room-2" }, method: "DELETE", path: "/api/v1/lock" });
});

test("a text and a group filter the tiles; STOP ALL stops all of them", async () => {
  const { page, station } = await open(crowd(30));
  await page.waitForSelector(".tile");
  await page.fill("#filter", "desk-3");
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 2);
  assert.deepEqual(await page.$$eval(".tile .name", (all) => all.map((it) => it.textContent)), ["desk-3", "desk-30"]);
  await page.fill("#filter", "");
  await page.click("#count [data-sort=offline]");
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 3);
  assert.equal(await page.locator(".tile[data-presence=present]").count(), 0);
  await page.click("#stop");
  await page.waitForSelector("#stop-status p");
  assert.equal(stops(station)[0].body.to, "all");
  await page.click("#count [data-sort=offline]");
  await page.fill("#filter", "no such thing");
  await page.waitForSelector("#none");
});

test("the lease holder is shown with the duration, and so is the requester", async () => {
  const lease = { client: 2, name: "Anna", is_program: false, since_s: 10 - 95, asked_by: [{ client: 3, name: "Ben" }, { client: 4, name: "Chen" }] };
  const { page } = await open([member("desk-1", { here: true, lease }), member("desk-2")]);
  await page.waitForSelector(".tile");
  assert.equal(await text(page, ".tile[data-member=desk-1] .who"), "Anna · 2 requesting");
  await page.click(".tile[data-member=desk-1] .name");
  await page.waitForSelector("#details .facts div");
  const facts = await page.$$eval("#details .facts div", (all) => all.map((it) => [it.querySelector("dt").textContent, it.querySelector("dd").textContent]));
  assert.deepEqual(facts.slice(0, 2), [["Control", "Anna, for 1 min 35 s"], ["Requests control", "Ben, Chen"]]);
});

test("the student of the slot is shown on the tile, beside an administrator who has control meanwhile", async () => {
  const lease = (name) => ({ client: 2, name, is_program: false, since_s: 1, asked_by: [] });
  const { page } = await open([member("desk-1", { here: true, ...time("Anna"), lease: lease("anna") }), member("desk-2", { ...time("Ben", 30), lease: lease("Ms Lee") }), member("desk-3", time("Chen"))]);
  await page.waitForSelector(".tile");
  assert.deepEqual(await page.$$eval(".tile .who", (all) => all.map((it) => it.textContent.trim())), ["Anna: 4 min 10 s left", "Ben: 30 s left · Ms Lee", "Chen: 4 min 10 s left"]);
  await page.fill("#filter", "chen");
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 1);
});

test("names are distributed over the arms of a group in turn, are listed there, and are removed", async () => {
  const groups = ["room-1"];
  const { page, station } = await open([member("desk-1", { here: true, groups, ...time("Zoë") }), member("desk-2", { groups }), member("desk-3", { groups: ["room-2"] }), member("desk-4", { groups, presence: { type: "away" } })]);
  await page.waitForSelector(".tile");
  const requests = (method) => asked(station, "/api/v1/fleet/requests").map(({ body }) => body).filter((it) => it.method === method && it.path === "/api/v1/slots");
  await page.selectOption("#group", "room-1");
  await page.click("#slots-open");
  await page.fill("#slots-group [name=names]", "Anna\nBen\n\n Chen ");
  await page.fill("#slots-group [name=minutes]", "10");
  await page.click("#slots-group [type=submit]");
  await page.waitForFunction(() => document.querySelector("#outcome")?.textContent.includes("2 of 2 have time slots."));
  const slot = (student, starts_in_s) => ({ student, group: "room-1", starts_in_s, ends_in_s: starts_in_s + 600 });
  assert.deepEqual(requests("PUT").map(({ to, body }) => [to, body.slots]), [[{ members: ["desk-1"] }, [slot("Anna", 0), slot("Chen", 600)]], [{ members: ["desk-2"] }, [slot("Ben", 0)]]]);
  await page.waitForFunction(() => document.querySelectorAll("#slots ol li").length === 3);
  assert.equal(await text(page, "#slots ol li:nth-of-type(2)"), "Chen in 10 min 00 s, for 10 min 00 s");
  assert.equal(await page.inputValue("#slots-group [name=names]"), "");
  await page.click("#slots [data-act=clear]");
  await page.waitForFunction(() => document.querySelector("#outcome").textContent.includes("2 of 3 have no time slots now."));
  assert.deepEqual(requests("DELETE").map(({ to }) => to), [{ group: "room-1" }]);
  await page.waitForSelector("#slots ol", { state: "detached" });
  // One at a time lies beside the tiles.
  await page.click(".tile[data-member=desk-1] .name");
  await page.waitForSelector("#slots", { state: "hidden" });
  await page.fill("#slots-arm [name=names]", "Mia");
  await page.click("#slots-arm [type=submit]");
  await page.waitForFunction(() => document.querySelector("#details ol.slots li")?.textContent.includes("Mia"));
  assert.deepEqual(requests("PUT").at(-1).body.slots, [{ student: "Mia", group: "room-1", starts_in_s: 0, ends_in_s: 900 }]);
});

test("a refusal of slots is shown in the station's words, and the names stay", async () => {
  const wrong = { type: "/api/v1/problems/bad-slots", title: "the time slots cannot be so", status: 422, detail: "ends_in_s of Anna is 90000; allowed is 1 to 86400" };
  const answer = ({ body }) => (body?.method === "PUT" ? { body: [{ member: "desk-1", id: "1", answer: { status: 422, body: wrong }, took_ms: 1 }] } : undefined);
  const { page } = await open([member("desk-1", { here: true })], { answer });
  await page.waitForSelector(".tile");
  await page.click("#slots-open");
  await page.fill("#slots-group [name=names]", "Anna");
  await page.click("#slots-group [type=submit]");
  await page.waitForFunction(() => document.querySelector("#outcome")?.textContent.includes("desk-1: The time slots are not valid: ends_in_s of Anna is 90000"));
  assert.equal(await page.inputValue("#slots-group [name=names]"), "Anna");
});

test("a student in a lesson is on the tile with the step, and stuck ones can be shown alone", async () => {
  const { page } = await open(crowd(12));
  await page.waitForSelector(".tile[data-member=desk-3] .learner");
  assert.equal(await text(page, ".tile[data-member=desk-3] .learner"), "Mia Tour (5 minutes) step 4 of 12 for 12 s");
  assert.match(await page.textContent(".tile[data-member=desk-7] .alarms"), /stuck/);
  assert.equal(await text(page, "#count [data-sort=stuck]"), "1 stuck");
  await page.click("#count [data-sort=stuck]");
  await page.waitForFunction(() => document.querySelectorAll(".tile").length === 1);
  await page.click(".tile[data-member=desk-7] .name");
  assert.equal(await text(page, "#details .learner"), "Chen Tour (5 minutes) step 5 of 12 for 7 min 11 s");
});

for (const [size, viewport] of Object.entries(SIZES)) {
  for (const arms of [5, 12, 30]) {
    test(`on a ${size}, none of ${arms} tiles moves when another one changes, and all of it fits`, async () => {
      const idle = crowd(arms).map((it) => ({ ...it, presence: { type: "present" }, state: { ...it.state, job: null, lease: null } }));
      const [first, second, third, fourth, fifth, ...others] = idle;
      const learners = [learner("Anna", 2), learner("Wolfeschlegelsteinhausenbergerdorff", 4, 431)];
      const answer = (learnerList) => ({ path }) => (path === "/api/v1/fleet/requests" ? { body: [{ member: fifth.name, id: fifth.id, answer: { status: 200, body: learnerList }, took_ms: 1 }] } : undefined);
      const places = (page) => page.$$eval(".tile", (all) => all.map((it) => [it.dataset.member, it.offsetLeft, it.offsetTop, it.offsetHeight]));
      const { page: calm } = await open(idle, { viewport, answer: answer([]) });
      await calm.waitForSelector(".tile");
      const before = await places(calm);

      const busy = { job: job("The harbour of a town whose name is long.svg", 40), lease: { client: 2, name: "Wolfeschlegelsteinhausenbergerdorff", is_program: false, since_s: 1, asked_by: ["Ben", "Chen"] }, ...time("Wolfeschlegelsteinhausenbergerdorff the younger") };
      const { page } = await open([
        first, { ...second, presence: { type: "away" } },
        { ...third, presence: { type: "refused", problem: { ...DENIED, detail: "two stations are called desk-3, and neither is asked for anything", hint: "start one of them with another --name; until then each is stopped on its own page" } } },
        { ...fourth, state: { ...fourth.state, ...busy } }, { ...fifth, state: { ...fifth.state, ...busy } }, ...others,
      ], { viewport, answer: answer(learners) });
      await page.waitForSelector(".tile[data-member=desk-5] .learner[data-stuck=true]");
      assert.deepEqual(await places(page), before);
      assert.deepEqual(await page.$$eval(".says", (all) => all.filter((it) => it.scrollHeight > it.clientHeight).map((it) => `${it.scrollHeight} of ${it.clientHeight}: ${it.textContent.trim()}`)), []);
      assert.match(await text(page, ".tile[data-member=desk-5] .learner"), /^Wolfe.* \+1 /);
    });
  }
}

test("a board that has lost its station shows that prominently, and recovers by itself", async () => {
  const { page, station } = await open([member("desk-1", { here: true })]);
  await page.waitForSelector(".tile");
  station.cut();
  await page.waitForSelector("#lost");
  await page.waitForSelector("#lost", { state: "detached" });
  assert.ok(asked(station, "/api/v1/fleet/events").length > 1);
});

test("a station without a fleet explains how to join one", async () => {
  const answer = ({ path }) => (path === "/api/v1/fleet" ? { status: 404, body: { type: "/api/v1/problems/no-fleet", title: "this station belongs to no fleet", status: 404, detail: "this station belongs to no fleet" } } : undefined);
  const { page } = await open([], { answer });
  await page.waitForSelector("#alone");
  assert.match(await text(page, "#alone"), /dobot up --fleet/);
});
