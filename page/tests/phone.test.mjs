// A phone is let in by a code on the page, with a token of its own that can be removed.
import assert from "node:assert/strict";
import { after, afterEach, before, test } from "node:test";
import { isJog, isStop, open } from "./bench.mjs";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
let bench, page;

before(async () => {
  bench = await open();
  ({ page } = bench);
});
after(() => bench.end());
afterEach(() => assert.deepEqual(bench.errors, []));

test("a station that no phone can reach says how to start it, and makes no token", async () => {
  await page.click("#tab-set_up");
  await page.click("#phone-use");
  await page.waitForSelector("#phone-near");
  assert.match(await page.textContent("#phone-near"), /--http 0\.0\.0\.0:8642/);
  assert.equal(await page.isVisible(".qr"), false);
  assert.deepEqual(await bench.ask("api/v1/tokens"), []);
});

test("the code leads a phone to the station in the network, with the chosen role until the token is removed", async () => {
  // A station of the network needs TLS, which not every build has: this one only says where it would be.
  let requests = 0;
  /** @type {() => void} */ let isMade;
  const made = new Promise((resolve) => (isMade = resolve));
  await page.route("**/api/v1/addresses", async (route) => {
    // On a busy machine a person presses the button before the answer to the view's own request.
    if ((requests += 1) === 1) await made;
    await route.fulfill({ json: ["https://192.168.1.7:8642"] });
  });
  await page.click("#tab-move");
  const requested = page.waitForRequest("**/api/v1/addresses");
  await page.click("#tab-set_up");
  await requested;
  await page.waitForSelector("#phone");
  await page.selectOption("#phone [name=role]", "watch");
  await page.dblclick("#phone-use");
  await page.waitForSelector("#token-made .qr");
  isMade();
  const address = await page.getAttribute("#token-address", "href");
  assert.match(address, /^https:\/\/192\.168\.1\.7:8642\/#token=[0-9a-f]{64}$/);
  const tokens = await bench.ask("api/v1/tokens");
  assert.deepEqual(tokens.map(({ name, role, shared }) => [name, role, shared]), [["phone", "watch", true]]);
  assert.equal(await page.isVisible(".refusal"), false, "a double press makes one token");
  const phone = await bench.visit(PHONE);
  await phone.goto("about:blank");
  await phone.goto(bench.url + new URL(address).hash);
  await phone.waitForFunction(() => document.querySelector("#jog-why")?.textContent.includes("only allows watching"));
  assert.equal(new URL(phone.url()).hash, "", "the token is not in the history");
  const from = bench.traffic.packets.length;
  const { x, y, width, height } = await phone.locator("[data-axis=y_plus]").boundingBox();
  await phone.touchscreen.tap(x + width / 2, y + height / 2);
  // Anyone may stop.
  await phone.tap("#stop");
  assert.ok(await bench.traffic.next(from, isStop));
  assert.equal(bench.traffic.packets.slice(from).some(isJog), false);
  await page.click(".tokens li:has-text('phone') button");
  await page.click("#confirm-yes");
  await phone.waitForSelector("#token");
});
