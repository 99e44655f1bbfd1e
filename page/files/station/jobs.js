// Reads the job list while it is visible, and sends requests about jobs.

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/types.js").Request} Request */
/** @typedef {import("../state/types.js").Reply} Reply */
/** @typedef {ReturnType<typeof createJobs>} JobRequests */

/** Polling interval of the visible list: jobs queued by other clients are not announced. */
const AGAIN_MS = 2000;

/**
 * @param {Store} store @param {import("./http.js").Http} http @param {import("./socket.js").Socket} socket
 * @param {() => void} takeControlIfFree takes control if no client has it
 */
export function createJobs(store, http, socket, takeControlIfFree) {
  const { send } = store;
  /** @type {number | undefined} */ let timer;
  /** Number of list requests: results of earlier ones are ignored. */
  let requests = 0;

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
  });

  /** Asks for something about a job, and keeps what is said against it. @param {number} job @param {Request} request @returns {Promise<Reply | undefined>} */
  async function ask(job, request) {
    const { problem, reply } = await socket.ask(request);
    send({ type: "job_refused", job, problem: problem ?? null });
    await read();
    return reply;
  }

  return {
    /** Starts a queued job, or goes on with a paused one. @param {number} job */
    start(job) {
      takeControlIfFree();
      void ask(job, { type: "start_job", job });
    },
    /** @param {number} job */
    pause: (job) => void ask(job, { type: "pause_job" }),
    /** @param {number} job */
    end: (job) => void ask(job, { type: "cancel_job", job }),
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
