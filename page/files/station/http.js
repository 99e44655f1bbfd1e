// HTTP requests to the station, with the access token if there is one.

/** @typedef {ReturnType<typeof createHttp>} Http */
/** @typedef {import("../state/types.js").Problem} Problem */
/** The result of a request: a value or a problem. @template T @typedef {{ value: T, problem?: undefined } | { value?: undefined, problem: Problem }} Outcome */

/** @type {Problem} */
const SILENT = { title: "the station does not respond", detail: "no response from the address of the station", hint: "check that the station is running; the page retries automatically" };

/** Timeout of a stop request, which frees its connection: a browser has six per station. */
const STOP_MS = 3000;

export function createHttp() {
  const token = () => sessionStorage.getItem("token");

  /** @returns {Record<string, string>} */
  function authorization() {
    const known = token();
    return known ? { authorization: `Bearer ${known}` } : {};
  }

  /** @param {string} path @param {AbortSignal} [signal] what ends an answer that goes on */
  const get = (path, signal) => fetch(path, { headers: authorization(), signal }).catch(() => undefined);

  /** @param {Record<string, string>} headers @param {string} method @param {string} path @param {unknown} [body] @param {AbortSignal} [signal] @returns {Promise<Outcome<any>>} */
  async function request(headers, method, path, body, signal) {
    if (body !== undefined) headers["content-type"] = "application/json";
    const answer = await fetch(path, { method, headers, body: body === undefined ? undefined : JSON.stringify(body), signal }).catch(() => undefined);
    if (!answer) return { problem: SILENT };
    const isJson = answer.headers.get("content-type")?.includes("json");
    const value = await (isJson ? answer.json() : answer.text()).catch(() => undefined);
    // The station ended, or the network was cut, in the middle of its answer.
    if (value === undefined) return { problem: SILENT };
    return answer.ok ? { value } : { problem: isJson ? value : { title: answer.statusText, detail: String(value), status: answer.status } };
  }

  return {
    token,
    /** @param {string} secret */
    useToken: (secret) => sessionStorage.setItem("token", secret),
    get,
    /** Returns the value, or undefined on failure. @template T @param {string} path @returns {Promise<T | undefined>} */
    async json(path) {
      const answer = await get(path);
      return answer?.ok ? answer.json() : undefined;
    },
    /**
     * Sends a request with an optional JSON body. A request with a key is carried out only once, even if it is repeated.
     * @template T @param {"GET" | "POST" | "PUT" | "DELETE"} method @param {string} path @param {unknown} [body] @param {string} [key] @returns {Promise<Outcome<T>>}
     */
    ask: (method, path, body, key) => request({ ...authorization(), ...(key && { "idempotency-key": key }) }, method, path, body),
    /** Requests a stop. No token is needed for it, so an unknown token must not prevent it. @template T @param {string} path @param {unknown} [body] @returns {Promise<Outcome<T>>} */
    async stop(path, body) {
      const outcome = await request(authorization(), "POST", path, body, AbortSignal.timeout(STOP_MS));
      return outcome.problem?.status === 401 && token() ? request({}, "POST", path, body, AbortSignal.timeout(STOP_MS)) : outcome;
    },
  };
}

/** A token in the address (`#token=...`) is taken out of it, and of the history. @param {Http} http */
export function takeToken(http) {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (!token) return;
  http.useToken(token);
  history.replaceState(null, "", location.pathname);
}
