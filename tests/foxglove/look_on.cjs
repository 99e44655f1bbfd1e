// Does Foxglove's own client read what a station tells while its arm moves?
const assert = require("node:assert/strict");
const { execFileSync, spawn } = require("node:child_process");
const { mkdtempSync, rmSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

const [, , dobot] = process.argv;
const data = mkdtempSync(join(tmpdir(), "dobot-foxglove-"));
const station = spawn(dobot, ["up", "--virtual", "--foxglove=127.0.0.1:0", "--http", "127.0.0.1:0", "--raw", "off", "--data", data, "--no-open"]);
const FAR = 60_000;

/** Where the station says that it is. */
const addresses = new Promise((found, failed) => {
  let text = "";
  station.stdout.on("data", (bytes) => {
    text += bytes;
    const [, page] = text.match(/page +(http:\S+)/) ?? [];
    const [, live] = text.match(/Foxglove +(ws:\S+)/) ?? [];
    if (page && live) found({ page, live });
  });
  station.on("exit", () => failed(new Error(`the station ended: ${text}`)));
});

/** What is told, by topic. */
async function lookOn(live) {
  const client = new FoxgloveClient({ ws: new WebSocket(live, ["foxglove.sdk.v1"]) });
  const channels = new Map(), topics = new Map(), told = new Map();
  client.on("message", ({ subscriptionId, timestamp, data }) => {
    const topic = topics.get(subscriptionId);
    told.get(topic).push({ timestamp, value: JSON.parse(new TextDecoder().decode(data)) });
  });
  await new Promise((offered, failed) => {
    client.on("error", failed);
    client.on("advertise", (list) => {
      for (const channel of list) {
        channels.set(channel.topic, channel);
        told.set(channel.topic, []);
        topics.set(client.subscribe(channel.id), channel.topic);
      }
      offered();
    });
  });
  return { channels, told, close: () => client.close() };
}

async function until(what, holds) {
  for (const end = Date.now() + FAR; Date.now() < end; await new Promise((again) => setTimeout(again, 20))) if (holds()) return;
  assert.fail(`it did not come: ${what}`);
}

async function main() {
  const { page, live } = await addresses;
  const { channels, told, close } = await lookOn(live);
  for (const topic of ["/tf", "/arm/pose", "/arm/joints", "/wire/to_arm", "/wire/from_arm", "/station/state", "/station/notices"]) {
    assert.equal(channels.get(topic)?.encoding, "json", topic);
    assert.equal(JSON.parse(channels.get(topic).schema).type, "object");
  }
  assert.equal(channels.get("/tf").schemaName, "foxglove.FrameTransform");
  await until("a state", () => told.get("/station/state").length > 0);
  execFileSync(dobot, ["confirm", "--station", page]);
  execFileSync(dobot, ["move", "220", "50", "30", "--path", "movl", "--station", page]);
  const last = () => told.get("/tf").at(-1)?.value.translation;
  await until("the tool where it was sent", () => last() && Math.hypot(last().x - 0.22, last().y - 0.05, last().z - 0.03) < 2e-4);
  const commands = told.get("/wire/to_arm").map(({ value }) => value.command).filter((it) => it?.type === "move_to");
  assert.deepEqual(commands.map(({ x_mm, y_mm, z_mm }) => [x_mm, y_mm, z_mm]), [[220, 50, 30]]);
  assert.ok(told.get("/station/notices").length > 0);
  assert.ok(told.get("/arm/joints").some(({ value }) => value.base_deg > 12));
  // The times are those of the messages, in the order in which they came.
  const times = told.get("/wire/from_arm").map(({ timestamp }) => timestamp);
  assert.ok(times.every((it, n) => n === 0 || it >= times[n - 1]));
  assert.ok(Math.abs(Number(times.at(-1) / 1_000_000n) - Date.now()) < FAR);
  console.log(`${channels.size} topics, ${times.length} statuses, ${commands.length} target: read`);
  close();
}

main().catch((error) => {
  console.error(error);
  process.exitCode = 1;
}).finally(() => {
  station.removeAllListeners("exit");
  station.on("exit", () => rmSync(data, { recursive: true, force: true }));
  station.kill("SIGINT");
});
