// Requests of the Set up tab.

import { isChanged } from "../state/set_up.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Schemas} Schemas */
/** @typedef {ReturnType<typeof createSetUp>} SetUpRequests */
/** @typedef {SetUpRequests["change"]} Change */

const CHECK_MS = 150;

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket */
export function createSetUp(store, http, socket) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  let checked = store.page.set_up.revision;
  /** Number of reads: an outdated answer must not restore an old policy. */
  let reads = 0;

  async function read() {
    const mine = reads += 1;
    const answer = await http.get("api/v1/policy/text");
    const text = answer?.ok ? await answer.text() : null;
    if (mine !== reads) return;
    if (text !== null) send({ type: "policy_text", text });
    if (store.page.role === "admin") {
      /** @type {Schemas["TokenView"][] | undefined} */
      const tokens = await http.json("api/v1/tokens");
      if (tokens) send({ type: "tokens", tokens });
      await readAddresses();
    }
    if (store.page.station?.link.address !== "virtual:") return;
    /** @type {string[] | undefined} */
    const faults = await http.json("api/v1/faults");
    if (faults) send({ type: "faults", faults });
  }

  async function readAddresses() {
    /** @type {string[] | undefined} */
    const addresses = await http.json("api/v1/addresses");
    if (addresses) send({ type: "addresses", addresses });
  }

  async function check() {
    const { revision, draft } = store.page.set_up;
    const { problem, value } = await http.ask("PUT", "api/v1/policy", { text: draft, check: true });
    const policy = problem ? null : /** @type {Schemas["Policy"]} */ (value);
    send({ type: "policy_checked", revision, check: problem ? { type: "bad", problem } : { type: "good" }, policy });
  }

  store.subscribe((page, message) => {
    const opened = message.type === "tab" && message.tab === "set_up";
    const again = page.tab === "set_up" && (message.type === "hello" || (message.type === "notice" && message.notice.type === "policy_changed"));
    if (opened || again) void read();
    if (page.set_up.revision === checked) return;
    checked = page.set_up.revision;
    clearTimeout(timer);
    if (page.set_up.draft !== null) timer = setTimeout(() => void check(), CHECK_MS);
  });

  /** Asks for a change, and keeps what is said against it. @template T @param {import("../state/set_up.js").Place} place @param {"GET" | "POST" | "PUT" | "DELETE"} method @param {string} path @param {unknown} [body] @returns {Promise<T | undefined>} */
  async function change(place, method, path, body) {
    const { problem, value } = await http.ask(method, path, body);
    send({ type: "set_up_refused", place, problem: problem ?? null });
    return /** @type {T | undefined} */ (value);
  }

  /** Changes a keep-out in the text of the draft; what was typed meanwhile stays. @param {Schemas["KeepOutEdit"]} edit */
  async function editKeepOut(edit) {
    const text = store.page.set_up.draft;
    if (text === null) return;
    /** @type {Schemas["PolicyDraft"] | undefined} */
    const edited = await change("policy", "POST", "api/v1/policy/keep-outs", { text, edit });
    if (!edited) return;
    if (store.page.set_up.draft !== text) return editKeepOut(edit);
    send({ type: "policy_typed", text: edited.text });
  }

  /** @param {string} name @param {Schemas["Role"]} role @param {boolean} shared Whether several people have it. */
  async function makeToken(name, role, shared) {
    /** @type {Schemas["NewToken"] | undefined} */
    const token = await change("tokens", "POST", "api/v1/tokens", { name, role, shared });
    if (token) send({ type: "token_made", token });
    await read();
  }

  /** @param {Schemas["Role"]} role */
  async function makePhoneToken(role) {
    // The page may not have read them yet, or they may have changed.
    await readAddresses();
    const { tokens, addresses } = store.page.set_up;
    if (!addresses.length) return send({ type: "phone_wanted" });
    const taken = new Set(tokens?.map(({ name }) => name));
    let name = "phone";
    for (let number = 2; taken.has(name); number += 1) name = `phone ${number}`;
    await makeToken(name, role, true);
  }

  /** The token for a phone that is being made. @type {Promise<void> | null} */
  let phone = null;

  return {
    change,
    editKeepOut,
    async keepPolicy() {
      const text = store.page.set_up.draft;
      if (text === null || !isChanged(store.page.set_up)) return;
      if (!await change("policy", "PUT", "api/v1/policy", { text, check: false })) return;
      send({ type: "policy_kept", text });
      await read();
    },
    makeToken,
    /** Makes a token for a phone, whose user gives a name there, if a phone can reach the station. @param {Schemas["Role"]} role */
    async usePhone(role) {
      // A double press makes one token.
      phone ??= makePhoneToken(role).finally(() => (phone = null));
      await phone;
    },
    /** @param {string} name */
    async removeToken(name) {
      await change("tokens", "DELETE", `api/v1/tokens/${encodeURIComponent(name)}`);
      send({ type: "token_made", token: null });
      await read();
    },
    /** @param {readonly string[]} faults */
    async setFaults(faults) {
      const set = await change("faults", "PUT", "api/v1/faults", { faults, seed: 0 });
      if (set) send({ type: "faults", faults: /** @type {string[]} */ (set) });
    },
    /** @param {string} scene */
    setWorld: (scene) => change("world", "PUT", "api/v1/world", { scene }),
    /** The arm moves a little. */
    async detect() {
      send({ type: "finding", finding: null });
      const { problem, reply } = await socket.ask({ type: "detect" });
      send({ type: "set_up_refused", place: "arm", problem: problem ?? null });
      if (reply?.type === "found") send({ type: "finding", finding: reply.finding });
    },
    /** @param {Schemas["Dialect"]} dialect */
    async useDialect(dialect) {
      const { problem } = await socket.ask({ type: "set_dialect", dialect });
      send({ type: "set_up_refused", place: "arm", problem: problem ?? null });
    },
  };
}
