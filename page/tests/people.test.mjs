// Two people at one arm tell each other apart: by name, device and time.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { isStop, open, takeControl, waitForAnswer } from "./bench.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let bench, page, traffic;

before(async () => {
  bench = await open();
  ({ page, traffic } = bench);
  await takeControl(page);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

const says = (page, id, pattern) => page.waitForFunction(([id, source]) => new RegExp(source).test(document.querySelector(id)?.textContent ?? ""), [id, pattern.source])
  .catch(async (error) => assert.fail(`${error.message}; ${id} says: ${await page.textContent(id)}`));
const named = async (page, id, name) => {
  await page.fill(`${id} input`, name);
  await page.click(`${id} button[type=submit]`);
  await page.waitForSelector(`${id}`, { state: "detached" });
};
/** Clears the stop, as a person does. */
async function reset(page) {
  await waitForAnswer(page, "api/v1/state", ({ stop }) => stop?.at_rest);
  await page.click("#reset");
  await page.click("#confirm-yes");
  await page.waitForSelector("#stopped", { state: "detached" });
}

test("nobody is asked for a name while alone, and each of two is asked once", async () => {
  assert.equal(await page.isVisible("#who"), false);
  const other = await bench.visit(PHONE);
  await page.waitForSelector("#who");
  await named(page, "#who", "Anna");
  await other.waitForSelector("#who");
  await other.tap("#who [data-act=no-name]");
  await other.waitForSelector("#who", { state: "detached" });
  for (const it of [page, other]) {
    await bench.enter(it);
    await it.waitForSelector("#link-chip[data-tone=good]");
    assert.equal(await it.isVisible("#who"), false);
  }
  await other.context().close();
});

test("control, a stop and the log name a person with the device, and the own page as such", async () => {
  const phone = await bench.visit(PHONE);
  await phone.waitForSelector("#who");
  await phone.fill("#who input", "Ben");
  await phone.tap("#who button[type=submit]");
  await phone.waitForSelector("#who", { state: "detached" });
  await phone.waitForSelector("#link-chip[data-tone=good]");
  await phone.tap("#take");
  await says(phone, "#holder", /^You have control\.$/);
  await says(page, "#holder", /^Ben has control on another page \(phone, since \d\d:\d\d.*\)\.$/);
  await page.click("#ask");
  await says(phone, ".give", /^Hand over to Anna \(computer\)$/);
  await phone.tap(".give");
  await says(phone, "#holder", /^Anna has control on another page \(computer, since/);
  const from = traffic.packets.length;
  await phone.tap("#stop");
  assert.ok(await traffic.next(from, isStop), "the stop reaches the arm");
  await says(phone, "#stopped-by", /^Stop requested by you\./);
  await says(page, "#stopped-by", /^Stop requested by Ben \(phone\)\./);
  const notices = await bench.ask("api/v1/notices");
  assert.ok(notices.some(({ text }) => text.includes("Ben (phone)")), "the log names both");
  await reset(page);
  await phone.context().close();
});

test("another tab of the same person is called so", async () => {
  const tab = await page.context().newPage();
  await bench.enter(tab);
  await says(tab, "#holder", /^Another page of yours has control \(computer, since/);
  await tab.close();
});

test("a program is named by where it runs", async () => {
  const from = traffic.packets.length;
  await fetch(`${bench.url}api/v1/stop`, { method: "POST" });
  assert.ok(await traffic.next(from, isStop));
  await says(page, "#stopped-by", /^Stop requested by a program on this computer\./);
  await reset(page);
});

test("a name that would mislead others is not taken", async () => {
  await page.click("#tab-set_up");
  for (const name of ["\u202eanna", "a\u200bb", "  "]) {
    await page.fill("#looks-name input", name);
    await page.click("#looks-name button[type=submit]");
    assert.equal(await page.locator("#looks-name input").evaluate((field) => field.checkValidity()), false, JSON.stringify(name));
    assert.equal(await page.evaluate(() => localStorage.getItem("dobot.name")), "Anna");
    const socket = new URL("api/v1/ws", bench.url);
    socket.searchParams.set("name", name);
    assert.equal((await fetch(socket)).status, 400, "nor by the station");
  }
});
