// Uses a virtual arm with the protocol's TypeScript library: node check.mjs ADDRESS, as check.sh starts it.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";

import { Client } from "@modelcontextprotocol/sdk/client/index.js";
import { StdioClientTransport } from "@modelcontextprotocol/sdk/client/stdio.js";
import { StreamableHTTPClientTransport } from "@modelcontextprotocol/sdk/client/streamableHttp.js";
import { ElicitRequestSchema } from "@modelcontextprotocol/sdk/types.js";

const DOBOT = process.env.DOBOT;
const ADDRESS = process.argv[2].replace(/\/$/, "");
const SQUARE = `<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm"><path d="M1 1h18v18h-18z" fill="none" stroke="black"/></svg>`;
const SLOW = { svg: SQUARE, options: { place: { pen_down: -40 }, tool: { speed: 2 } } };

/** An agent; its person answers every question alike, or cannot be asked. */
async function agent(transport, answer) {
  const client = new Client({ name: "check", version: "1" }, { capabilities: answer ? { elicitation: {} } : {} });
  const questions = [];
  if (answer) {
    client.setRequestHandler(ElicitRequestSchema, ({ params }) => {
      questions.push(params.message);
      return { action: answer, ...(answer === "accept" && { content: {} }) };
    });
  }
  await client.connect(transport);
  const call = (name, args = {}, options = {}) =>
    client.callTool({ name, arguments: args }, undefined, { timeout: 600_000, ...options });
  return { client, call, questions };
}

const program = (...options) =>
  new StdioClientTransport({ command: DOBOT, args: ["mcp", ...options], env: { DOBOT_DATA: process.env.DOBOT_DATA } });

const dobot = (...words) => execFileSync(DOBOT, words, { stdio: "pipe" });

function done(result) {
  assert.ok(!result.isError, JSON.stringify(result));
  return result.structuredContent;
}

function refused(result, kind) {
  assert.ok(result.isError && result.structuredContent.kind === kind, JSON.stringify(result));
}

/** Cancels a job, and waits until the arm is free. */
async function cancel(call, job) {
  done(await call("change_job", { job, action: "cancel" }));
  while (done(await call("look")).job);
}

const CHECKS = {
  async "tools are described in less than 8 kB, and resources and prompts can be read"() {
    const { client } = await agent(program());
    const { tools } = await client.listTools();
    assert.ok(JSON.stringify({ tools }).length < 8000);
    for (const tool of tools) assert.ok(tool.title && tool.description && tool.outputSchema.type === "object", tool.name);
    for (const { uri } of (await client.listResources()).resources) {
      assert.ok((await client.readResource({ uri })).contents[0].text.length > 1, uri);
    }
    assert.equal((await client.listPrompts()).prompts.length, 2);
    await client.close();
  },

  async "a person is asked before a move"() {
    const to = { x_mm: 205, y_mm: -10, z_mm: 35 };
    const declined = await agent(program(), "decline");
    refused(await declined.call("move_to", to), "needs-a-person");
    await declined.client.close();
    const accepted = await agent(program(), "accept");
    const moved = done(await accepted.call("move_to", to));
    assert.ok(Math.abs(moved.arm.x_mm - 205) < 0.1, JSON.stringify(moved));
    assert.match(accepted.questions.join(), /x 205, y -10, z 35 mm/);
    await accepted.client.close();
    const alone = await agent(program());
    refused(await alone.call("move_to", to), "needs-a-person");
    await alone.client.close();
  },

  async "an agent cannot resume what a person paused, and progress is reported"() {
    const { client, call, questions } = await agent(program("--may-move"), "accept");
    const { drawing } = done(await call("plan_drawing", SLOW));
    const reported = [];
    const drawn = call("draw", { drawing, wait_s: 600 }, { onprogress: (progress) => reported.push(progress) });
    while (reported.length < 2) await new Promise(setImmediate);
    dobot("jobs", "pause");
    const { job } = done(await drawn);
    assert.equal(job.phase, "paused");
    refused(await call("change_job", { job: job.job, action: "resume" }), "needs-a-person");
    await cancel(call, job.job);
    assert.ok(reported.every(({ progress, total }) => progress <= total));
    assert.deepEqual(questions, []);
    await client.close();
  },

  async "an agent cannot confirm for a person"() {
    const { client, call, questions } = await agent(program("--may-move"), "accept");
    const text = `title = "swap"
[[steps]]
go = { x = 200, y = 0, z = 50 }
[[steps]]
wait = "put in the red pen"
[[steps]]
go = { x = 210, y = 0, z = 50 }
`;
    let { job } = done(await call("run_program", { program: { text }, wait_s: 60 }));
    // The list of jobs is a little behind.
    while (!job.waits_for_person) ({ job } = done(await call("jobs", { job: job.job })));
    refused(await call("change_job", { job: job.job, action: "resume" }), "needs-a-person");
    await cancel(call, job.job);
    done(await call("stop", {}));
    refused(await call("move_joints", { base_deg: 0, rear_deg: 45, fore_deg: 45 }), "stopped");
    assert.deepEqual(questions, []);
    await client.close();
    dobot("stop", "--reset");
  },

  async "over HTTP an agent without a token moves nothing and asks nobody"() {
    const { client, call, questions } = await agent(new StreamableHTTPClientTransport(new URL(`${ADDRESS}/mcp`)), "accept");
    refused(await call("move_to", { x_mm: 200, y_mm: 0, z_mm: 30 }), "needs-a-person");
    assert.deepEqual(questions, []);
    await client.close();
  },
};

for (const [name, check] of Object.entries(CHECKS)) {
  await check();
  console.log(`typescript: ${name}`);
}
