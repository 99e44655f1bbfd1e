// Does Foxglove's own client read what a station tells while its arm moves?
const assert = require("node:assert/strict");
const { execFileSync, spawn } = require("node:child_process");
const { cpSync, mkdtempSync, rmSync } = require("node:fs");
const { tmpdir } = require("node:os");
const { join } = require("node:path");
const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

const [, , dobot, kept] = process.argv;
const data = mkdtempSync(join(tmpdir(), "dobot-foxglove-"));
const station = spawn(dobot, ["up", "--virtual", "--foxglove=127.0.0.1:0", "--http", "127.0.0.1:0", "--raw", "off", "--data", data, "--no-open"]);
const SQUARE = join(__dirname, "../../examples/drawings/square.svg");
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

/** The messages, by topic. */
async function lookOn(live) {
  const client = new FoxgloveClient({ ws: new WebSocket(live, ["foxglove.sdk.v1"]) });
  const channels = new Map(), topics = new Map(), messages = new Map();
  client.on("message", ({ subscriptionId, timestamp, data }) => {
    const topic = topics.get(subscriptionId);
    messages.get(topic).push({ timestamp, value: JSON.parse(new TextDecoder().decode(data)) });
  });
  await new Promise((offered, failed) => {
    client.on("error", failed);
    client.on("advertise", (list) => {
      for (const channel of list) {
        channels.set(channel.topic, channel);
        messages.set(channel.topic, []);
        topics.set(client.subscribe(channel.id), channel.topic);
      }
      offered();
    });
  });
  return { channels, messages, close: () => client.close() };
}

async function until(what, holds) {
  for (const end = Date.now() + FAR; Date.now() < end; await new Promise((again) => setTimeout(again, 20))) if (holds()) return;
  assert.fail(`it did not come: ${what}`);
}

/** Where the origin of a link is in the frame `base`, by the transforms of one message. */
function place(transforms, frame) {
  let at = [0, 0, 0];
  while (frame !== "base") {
    const link = transforms.find(({ child_frame_id }) => child_frame_id === frame);
    assert.ok(link, `no transform of ${frame}`);
    const { translation: t, rotation: { x, y, z, w } } = link;
    const cross = ([a, b, c]) => [y * c - z * b, z * a - x * c, x * b - y * a];
    const once = cross(at), twice = cross(once);
    at = at.map((it, n) => it + 2 * (w * once[n] + twice[n]) + [t.x, t.y, t.z][n]);
    frame = link.parent_frame_id;
  }
  return at;
}

/** The lines of ink in the messages, each a list of points; every piece is sent once. */
function inkOf(messages) {
  const entities = messages.get("/arm/ink").flatMap(({ value }) => value.entities);
  assert.equal(new Set(entities.map(({ id }) => id)).size, entities.length);
  assert.ok(entities.every(({ frame_id }) => frame_id === "base"));
  return entities.flatMap(({ lines }) => lines.map(({ points }) => points.map(({ x, y, z }) => [x, y, z])));
}

const lengthOf = (line) => line.slice(1).reduce((sum, [x, y], n) => sum + Math.hypot(x - line[n][0], y - line[n][1]), 0);

/** Whether lines are the square of the drawing: 30 mm wide, with nothing beside its edges. */
function assertSquare(lines, z_m) {
  const points = lines.flat(), xs = points.map(([x]) => x), ys = points.map(([, y]) => y);
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  for (const side of [x1 - x0, y1 - y0]) assert.ok(Math.abs(side - 0.03) < 1e-4, `${side}`);
  const beside = ([x, y]) => Math.min(...[x - x0, x - x1, y - y0, y - y1].map(Math.abs));
  for (const point of points) {
    assert.ok(beside(point) < 1e-4, `${point} is beside the square`);
    assert.ok(Math.abs(point[2] - z_m) < 1e-5, `${point} is not at ${z_m}`);
  }
  const drawn = lines.reduce((sum, line) => sum + lengthOf(line), 0);
  assert.ok(Math.abs(drawn - 0.12) < 2e-4, `${drawn} m are drawn`);
}

async function main() {
  const { page, live } = await addresses;
  const { channels, messages, close } = await lookOn(live);
  const topics = ["/tf", "/arm/ink", "/arm/target", "/arm/pose", "/arm/joints", "/wire/to_arm", "/wire/from_arm", "/station/state", "/station/notices"];
  // A client that connects while a station starts receives the topics one after the other.
  await until("all topics", () => topics.every((topic) => channels.has(topic)));
  for (const topic of topics) {
    assert.equal(channels.get(topic).encoding, "json", topic);
    assert.equal(JSON.parse(channels.get(topic).schema).type, "object");
  }
  assert.equal(channels.get("/tf").schemaName, "foxglove.FrameTransforms");
  for (const topic of ["/arm/ink", "/arm/target"]) assert.equal(channels.get(topic).schemaName, "foxglove.SceneUpdate");
  await until("a state", () => messages.get("/station/state").length > 0);
  execFileSync(dobot, ["confirm", "--station", page]);
  execFileSync(dobot, ["move", "220", "50", "30", "--path", "movl", "--station", page]);
  const last = () => messages.get("/tf").at(-1)?.value.transforms;
  await until("the tool where it was sent", () => {
    const [x, y, z] = last() ? place(last(), "tool") : [];
    return Math.hypot(x - 0.22, y - 0.05, z - 0.03) < 2e-4;
  });
  // The links of the URDF bring the tool to the pose that the arm tells; how long the tool is, the policy says.
  const { position } = messages.get("/arm/pose").at(-1).value.pose;
  place(last(), "tool").forEach((it, n) => assert.ok(Math.abs(it - [position.x, position.y, position.z][n]) < 1e-6, `${it}`));
  const tip_m = place(last(), "tool")[2] - place(last(), "tip")[2];
  assert.ok(tip_m >= 0.02 && tip_m <= 0.2, `${tip_m}`);
  // The target was shown with the way to it, and is gone where the arm has come there.
  await until("the end of the target", () => messages.get("/arm/target").at(-1)?.value.deletions[0]?.id === "target");
  const [target] = messages.get("/arm/target")[0].value.entities;
  const { points } = target.lines[0], aim = target.spheres[0].pose.position;
  assert.ok(Math.hypot(aim.x - 0.22, aim.y - 0.05, aim.z - (0.03 - tip_m)) < 2e-5);
  assert.equal(points.length, 17);
  assert.deepEqual(points.at(-1), aim);
  assert.equal(messages.get("/arm/ink").length, 0);
  const commands = messages.get("/wire/to_arm").map(({ value }) => value.command).filter((it) => it?.type === "move_to");
  assert.deepEqual(commands.map(({ x_mm, y_mm, z_mm }) => [x_mm, y_mm, z_mm]), [[220, 50, 30]]);
  assert.ok(messages.get("/station/notices").length > 0);
  assert.ok(messages.get("/arm/joints").some(({ value }) => value.base_deg > 12));
  // The times are those of the messages, in the order in which they came.
  const times = messages.get("/wire/from_arm").map(({ timestamp }) => timestamp);
  assert.ok(times.every((it, n) => n === 0 || it >= times[n - 1]));
  assert.ok(Math.abs(Number(times.at(-1) / 1_000_000n) - Date.now()) < FAR);
  execFileSync(dobot, ["draw", SQUARE, "--pen-down", "-40", "--station", page]);
  await until("the square", () => Math.abs(inkOf(messages).reduce((sum, line) => sum + lengthOf(line), 0) - 0.12) < 2e-4);
  assertSquare(inkOf(messages), -0.04 - tip_m);
  // A late client receives all of it, and the others do not receive it again.
  const before = messages.get("/arm/ink").length;
  const late = await lookOn(live);
  await until("the ink, late", () => inkOf(late.messages).length === inkOf(messages).length);
  assertSquare(inkOf(late.messages), -0.04 - tip_m);
  assert.equal(messages.get("/arm/ink").length, before);
  late.close();
  console.log(`${channels.size} topics, ${times.length} statuses, ${commands.length} target: read`);
  close();
}

main().catch((error) => {
  console.error(error);
  process.exitCode = 1;
}).finally(() => {
  station.removeAllListeners("exit");
  station.on("exit", () => {
    if (kept) cpSync(join(data, "recordings"), kept, { recursive: true });
    rmSync(data, { recursive: true, force: true });
  });
  station.kill("SIGINT");
});
