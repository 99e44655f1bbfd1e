// Reads the job list while it is visible, and sends requests about jobs.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Request} Request */
/** @typedef {import("../state/types.js").Reply} Reply */
/** @typedef {import("../state/types.js").Problem} Problem */
/** @typedef {ReturnType<typeof createJobs>} JobRequests */

/** Polling interval of the visible list: jobs queued by other clients are not announced. */
const AGAIN_MS = 2000;

/** @param {Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket */
export function createJobs(store, http, socket) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  /** Number of list requests: results of earlier ones are ignored. */
  let requests = 0;
  /** Whether the job was started, and no state has shown it yet. */
  let isStarted = false;

  const isSeen = () => store.page.tab === "jobs" && !document.hidden;

  async function read() {
    clearTimeout(timer);
    const mine = requests += 1;
    const all = await http.json("api/v1/jobs");
    if (mine !== requests) return;
    if (all) send({ type: "jobs", all });
    if (store.page.tab === "jobs") timer = setTimeout(() => (isSeen() ? void read() : undefined), AGAIN_MS);
  }

  document.addEventListener("visibilitychange", () => isSeen() && void read());
  store.subscribe((page, message) => {
    const news = message.type === "hello" || (message.type === "tab" && message.tab === "jobs") || (message.type === "notice" && message.notice.type === "job");
    if (news && page.tab === "jobs") void read();
    if (!isStarted || (message.type !== "state" && message.type !== "closed")) return;
    isStarted = false;
    send({ type: "job_starting", starting: false });
  });

  /** Sends a request about a job. A refusal is shown at the job, or on top of the page where no list is visible. @param {number} job @param {Request} request @returns {Promise<Reply | undefined>} */
  async function ask(job, request) {
    const { problem, reply } = await socket.ask(request);
    send({ type: "job_refused", job, problem: problem ?? null });
    if (problem && !isSeen()) send({ type: "problem", problem });
    await read();
    return reply;
  }

  /** Removes a job that could not be started. @param {number} job */
  async function discard(job) {
    await socket.ask({ type: "cancel_job", job });
    await socket.ask({ type: "forget_job", job });
  }

  /**
   * Creates a job at a path of the API and starts it; a job that cannot be started is removed. Only one is started at a time.
   * @param {string} path @param {unknown} body @param {"start_job" | "step_job"} [type] @returns {Promise<{ job?: number, problem?: Problem }>}
   */
  async function run(path, body, type = "start_job") {
    if (store.page.jobs.starting) return {};
    send({ type: "job_starting", starting: true });
    const { value, problem: refused } = await http.ask("POST", path, body);
    /** @type {number | undefined} */
    const job = value?.job.job;
    const problem = job === undefined ? refused : (await socket.ask({ type, job })).problem;
    if (problem && job !== undefined) await discard(job);
    if (problem) send({ type: "job_starting", starting: false });
    else isStarted = true;
    return problem ? { problem } : { job };
  }

  return {
    run,
    /** Starts a queued job, or resumes a paused one. @param {number} job */
    start: (job) => void ask(job, { type: "start_job", job }),
    /** Runs the next step of a paused job alone. @param {number} job @returns {Promise<Problem | undefined>} */
    step: async (job) => (await socket.ask({ type: "step_job", job })).problem,
    /** @param {number} job */
    pause: (job) => void ask(job, { type: "pause_job" }),
    /** @param {number} job */
    end: (job) => ask(job, { type: "cancel_job", job }),
    /** @param {number} job */
    forget: (job) => void ask(job, { type: "forget_job", job }),
    /** @param {number} job @param {number | null} before */
    move: (job, before) => void ask(job, { type: "move_job", job, before }),
    /** Repeats a job: immediately, or queued if another job is active. @param {number} job */
    async again(job) {
      const isFree = !store.page.station?.job;
      const reply = await ask(job, { type: "queue_again", job });
      if (isFree && reply?.type === "job") this.start(reply.job.job);
    },
  };
}
