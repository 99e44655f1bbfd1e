// The program `dobot`, started and ended.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";

const DOBOT = process.env.DOBOT ?? "dobot";

/** Starts the program, and waits for a line of it; with `within`, through another program that becomes it, such as `ip netns exec`. */
export async function start(words, line, within = []) {
  const [program, ...rest] = [...within, DOBOT, ...words];
  const child = spawn(program, rest, { stdio: ["ignore", "pipe", "inherit"] });
  for await (const text of createInterface({ input: child.stdout })) {
    const found = text.match(line);
    if (found) {
      child.stdout.resume();
      return { child, found: found[1] };
    }
  }
  throw new Error(`dobot ${words.join(" ")} ended without ${line}`);
}

/** Starts a router of the fleet, and returns its address as found. */
export const startRouter = (words, within) => start(["fleet", "router", ...words], /router listening at (\S+)/, within);

/** Ends it, unless it has ended. */
export async function end(child, signal) {
  if (child.exitCode !== null || child.signalCode !== null) return;
  const over = once(child, "exit");
  child.kill(signal);
  await over;
}
