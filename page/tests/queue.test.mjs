// The shared queue of the board, on a mock station: submitted jobs, uncertain jobs, and the form.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { launch, leave, visitor } from "./browser.mjs";
import { SILENT, member, mockStation, work } from "./mock_station.mjs";

const WORK = "/api/v1/fleet/work";

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

const DESKS = [
  member("desk-1", { here: true, takes_work: "queue", offers: ["pen"] }),
  member("desk-2", { takes_work: "start", offers: ["pen", "a5"], groups: ["room-2"] }),
  member("desk-3", { offers: ["laser"] }),
];
const of = (n) => ({ member: { name: DESKS[n].name, id: DESKS[n].id } });

/** The board with its queue open; `submitted` is what the station tells of it, and can be changed. */
async function open(submitted, answer) {
  const station = await mockStation(DESKS, answer, submitted);
  const context = await visitor(browser, { viewport: { width: 1440, height: 900 }, reducedMotion: "reduce" });
  const page = await context.newPage();
  page.on("pageerror", (error) => errors.push(error));
  opened.push(() => context.close(), () => station.end());
  await page.goto(station.url);
  await page.waitForSelector(".tile");
  await page.click("#queue-open");
  await page.waitForSelector("#queue [data-work], #queue-none");
  return { page, asked: (method, path = WORK) => station.asked.filter((it) => it.method === method && it.path === path) };
}
const entry = (id) => `#queue [data-work^=${id}]`;
const text = (page, selector) => page.textContent(selector).then((it) => it.replace(/\s+/g, " ").trim());

test("each entry shows its student, its needs, its arm and the progress of that arm", async () => {
  const job = { job: 4, title: "x", kind: "drawing", phase: "running", commands: 100, completed: 40 };
  const { page } = await open([work("a1", "taken", { ...of(1), group: "room-2", job }), work("a2", "waiting", { reason: "desk-1: the drawing is out of reach" })]);
  assert.match(await text(page, `${entry("a1")} .whose`), /^Anna \(room-2\) · needs pen · submitted /);
  assert.equal(await text(page, `${entry("a1")} .where`), "desk-2: job 4, running");
  assert.equal(await page.$eval(`${entry("a1")} progress`, (it) => it.value), 0.4);
  assert.match(await text(page, entry("a2")), /Desk-1: the drawing is out of reach/);
  assert.equal(await page.textContent("#queue-open"), "Queue: 2");
});

test("work in doubt shows the reason in the station's words, and goes to another arm only after a confirmation", async () => {
  const submitted = [work("a1", "offered", { ...of(1), doubt: "desk-2 cannot be reached; it may have been drawn" })];
  const answer = ({ path }) => (path.endsWith("/give") ? { body: (submitted[0] = work("a1", "waiting", { before: [{ ...of(1), drawn: "it may have been drawn", is_settled: false }] })) } : undefined);
  const { page, asked } = await open(submitted, answer);
  const give = `${WORK}/${submitted[0].id}/give`;
  assert.equal(await page.textContent("#queue-open"), "Queue: 1, 1 uncertain");
  assert.equal(await text(page, `${entry("a1")} .status-of`), "Desk-2 cannot be reached; it may have been drawn.");
  await page.click(`${entry("a1")} [data-act=reassign]`);
  assert.match(await text(page, "#confirm-text"), /Desk-2 cannot be reached; it may have been drawn\. Look at the paper of desk-2 first/);
  await page.click("#confirm-no");
  assert.equal(asked("POST", give).length, 0);
  await page.click(`${entry("a1")} [data-act=reassign]`);
  await page.click("#confirm-yes");
  await page.waitForSelector(`${entry("a1")}[data-phase=waiting]`);
  assert.equal(asked("POST", give).length, 1);
  assert.equal(await text(page, `${entry("a1")} .before`), "Earlier, at desk-2: it may have been drawn");
});

test("waiting work is cancelled after a question; a refusal is shown next to the request", async () => {
  const refused = { type: "/api/v1/problems/work-phase", title: "not now", status: 409, detail: "it is Done; what is waiting, offered or taken can be cancelled" };
  const { page, asked } = await open([work("a1", "waiting")], ({ method }) => (method === "DELETE" ? { status: 409, body: refused } : undefined));
  await page.click(`${entry("a1")} [data-act=cancel]`);
  await page.click("#confirm-yes");
  await page.waitForSelector(`${entry("a1")} [role=alert]`);
  assert.match(await text(page, `${entry("a1")} [role=alert]`), /: it is Done; what is waiting/);
  assert.equal(asked("DELETE", `${WORK}/${work("a1").id}`).length, 1);
});

test("a drawing is submitted with its student, its group and available needs, and only once even if an answer is lost", async () => {
  const submitted = [];
  let isLost = true;
  const answer = ({ method, path, body }) => {
    if (method !== "POST" || path !== WORK) return undefined;
    if (isLost) return SILENT;
    submitted.push(work("b1", "waiting", { title: body.drawing.name }));
    return { status: 201, body: submitted[0] };
  };
  const { page, asked } = await open(submitted, answer);
  assert.ok(await page.isDisabled("#submit-send"));
  // A laser is told by a station that takes no work: it cannot be asked for here.
  assert.deepEqual(await page.$$eval("#submit-needs input", (all) => all.map((it) => it.value)), ["a5", "pen"]);
  await page.setInputFiles("#submit-file", { name: "house.svg", mimeType: "image/svg+xml", buffer: Buffer.from("<svg/>") });
  await page.fill("#submit-student", "Anna");
  await page.fill("#submit-group", "room-2");
  await page.check("#submit-needs [value=a5]");
  await page.waitForFunction(() => document.querySelector("#submit-arms").textContent === "Suitable arms: desk-2.");
  await page.fill("#submit-down", "-40");
  await page.click("#submit-send");
  await page.waitForSelector("#submit [role=alert]");
  assert.match(await text(page, "#submit [role=alert]"), /no response from the address of the station/);
  isLost = false;
  await page.click("#submit-send");
  await page.waitForSelector("#submitted");
  assert.equal(await text(page, "#submitted"), "house.svg submitted.");
  await page.waitForSelector(entry("b1"));
  const [first, second] = asked("POST");
  assert.deepEqual(second.body, { drawing: { name: "house.svg", file: Buffer.from("<svg/>").toString("base64"), options: { place: { fit: false, pen_down: -40 } } }, needs: ["a5"], student: "Anna", group: "room-2" });
  assert.match(first.key, /^[0-9a-f]{32}$/);
  assert.equal(second.key, first.key, "the same submission, so that it is kept once");
  // The next one is another one.
  await page.check("[name=submit-what][value=text]", { force: true });
  await page.fill("#submit-text", "Ben");
  await page.click("#submit-send");
  await page.waitForFunction(() => document.querySelector("#submit-text")?.value === "");
  assert.notEqual(asked("POST").at(-1).key, first.key);
  assert.deepEqual(asked("POST").at(-1).body.drawing, { options: { what: { text: "Ben" }, place: { fit: false, pen_down: -40 } } });
});

test("a drawing dropped anywhere on the board can be submitted, and does not replace the board", async () => {
  const { page } = await open([]);
  await page.click("#queue-close");
  const files = await page.evaluateHandle(() => {
    const files = new DataTransfer();
    files.items.add(new File(["<svg/>"], "cup.svg"));
    return files;
  });
  await page.dispatchEvent(".tile", "drop", { dataTransfer: files });
  await page.waitForSelector("#submit-name");
  assert.equal(await page.textContent("#submit-name"), "cup.svg");
});

test("the details of an arm show its work in the queue, and the waiting work that it could accept", async () => {
  const { page } = await open([work("a1", "taken", of(1)), work("a2", "waiting", { needs: ["a5"] }), work("a3", "waiting", { needs: ["laser"] })]);
  await page.click(".tile[data-member=desk-2] .name");
  await page.waitForSelector("#details-queue");
  assert.deepEqual(await page.$$eval("#details [data-work]", (all) => all.map((it) => it.dataset.work.slice(0, 2))), ["a1", "a2"]);
  assert.equal(await page.isVisible("#queue"), false);
});
