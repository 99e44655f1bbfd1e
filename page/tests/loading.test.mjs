// Loading: what a first and a second visit transfer, what comes first, an old page, a station that is gone. The files are always
// those of the program, not of the folder.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, leave, visitor } from "./browser.mjs";
import { open } from "./bench.mjs";

/** The transfer of a slow line: 1.5 Mbit/s, 150 ms. */
const LINE = { bytes_per_s: 1.5e6 / 8, latency_s: 0.15 };
/** The connections of a browser to a station. */
const CONNECTIONS = 6;
/** What a second visit may transfer. */
const SECOND_BYTES = 50_000;

let bench, browser;

before(async () => {
  delete process.env.FILES;
  bench = await open({ virtual: true });
  browser = await launch();
});
after(async () => {
  await leave(browser);
  await bench.end();
});

/** The files of a visit, in the order of their requests, with the bytes that came over the line. */
async function visit(page) {
  const came = [];
  const client = await page.context().newCDPSession(page);
  await client.send("Network.enable");
  const requests = new Map();
  client.on("Network.requestWillBeSent", ({ requestId, request }) => requests.set(requestId, { path: new URL(request.url).pathname, bytes: 0, cached: false }));
  client.on("Network.requestServedFromCache", ({ requestId }) => requests.get(requestId) && (requests.get(requestId).cached = true));
  client.on("Network.loadingFinished", ({ requestId, encodedDataLength }) => {
    const request = requests.get(requestId);
    if (request && !request.path.startsWith("/api/") && !request.path.startsWith("data")) came.push({ ...request, bytes: request.cached ? 0 : encodedDataLength });
  });
  return { came, requested: () => [...requests.values()].filter(({ path }) => path.startsWith("/") && !path.startsWith("/api/")), end: () => client.detach() };
}

/** Waits until the page is complete. */
const complete = (page) => page.waitForFunction(() => document.querySelector("[data-pose=x_mm]")?.textContent !== "–");

/** Waiting and transfers overlap; `npm run latency` measures 4.6 s for what takes 5.5 s one after the other. */
const OVERLAP = 0.85;

/** The time of transfers over the slow line: each request takes a turn on one of the connections. */
const time_s = (count, bytes) => OVERLAP * (LINE.latency_s * (2 + Math.ceil(count / CONNECTIONS)) + bytes / LINE.bytes_per_s);

test("a first visit is small enough for a slow line, and what STOP needs comes first", async () => {
  const context = await visitor(browser);
  const page = await context.newPage();
  const { came, requested, end } = await visit(page);
  await page.goto(bench.url);
  await complete(page);
  const own = requested().map(({ path }) => path);
  const stop = own.findIndex((path) => path.endsWith("/station/stop.js"));
  const app = own.findIndex((path) => path.endsWith("/app.js"));
  assert.ok(stop > 0 && stop < 10 && stop < app, `stop.js is request ${stop}, app.js ${app}`);
  for (const later of ["/three/", "/js-aruco2/"]) assert.ok(!own.some((path) => path.includes(later)), `${later} is loaded later, if at all`);
  const bytes = came.reduce((sum, file) => sum + file.bytes, 0);
  const first = came.filter(({ path }) => own.indexOf(path) <= stop);
  const stop_s = time_s(first.length, first.reduce((sum, file) => sum + file.bytes, 0));
  assert.ok(stop_s <= 1.5, `STOP after ${stop_s.toFixed(2)} s`);
  const page_s = time_s(came.length, bytes);
  assert.ok(page_s <= 5, `the page after ${page_s.toFixed(2)} s: ${came.length} files, ${bytes} bytes`);
  await end();

  const second = await visit(page);
  await page.reload();
  await complete(page);
  const again = second.came.reduce((sum, file) => sum + file.bytes, 0);
  assert.ok(again <= SECOND_BYTES, `a second visit transfers ${again} bytes`);
  await second.end();
  await context.close();
});

test("a page that is older than the station says so, and reloads", async () => {
  const context = await visitor(browser);
  const page = await context.newPage();
  await page.route(bench.url, async (route) => {
    const answer = await route.fetch();
    const body = (await answer.text()).replace(/(name="dobot-page" content=")[^"]+/, "$1page-000000000000");
    return route.fulfill({ response: answer, body });
  }, { times: 1 });
  await page.goto(bench.url);
  await page.waitForSelector("#stale");
  assert.match(await page.textContent("#stale"), /older than the station/);
  await page.click("#stale-reload");
  await complete(page);
  assert.equal(await page.locator("#stale").count(), 0);
  await context.close();
});

test("an installed page says at once that the station does not answer", async () => {
  const context = await visitor(browser, { serviceWorkers: "allow" });
  const page = await context.newPage();
  await page.goto(bench.url);
  await page.evaluate(() => navigator.serviceWorker.ready.then(() => {}));
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await context.setOffline(true);
  await page.goto(bench.url);
  assert.match(await page.textContent("h1"), /does not answer/);
  await context.setOffline(false);
  await page.goto(bench.url);
  await complete(page);
  await context.close();
});

test("the page can be installed: its manifest and icon are served", async () => {
  const manifest = await bench.ask("manifest.webmanifest");
  assert.equal(manifest.display, "standalone");
  for (const { src, type } of manifest.icons) {
    const icon = await fetch(new URL(src, bench.url));
    assert.equal(icon.status, 200);
    assert.equal(icon.headers.get("content-type"), type);
  }
});
