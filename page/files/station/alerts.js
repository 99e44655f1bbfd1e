// Calls a person who looks elsewhere: by a notification of the browser, a sound, and the title and icon of the tab.

import { newsOf, titleOf, iconOf } from "../state/alerts.js";

/** @typedef {import("../state/store.js").Store} Store */
/** @typedef {import("../state/alerts.js").Alerts} Alerts */
/** @typedef {ReturnType<typeof createAlerts>} AlertRequests */

/** Storage key of what a person wants. */
const KEY = "dobot.alerts";
/** The sound: two short tones. */
const TONES = [{ hertz: 880, at_s: 0 }, { hertz: 1175, at_s: 0.18 }];
const TONE_S = 0.15, LOUDNESS = 0.2;

/** What a person wants, as kept in this browser. @returns {Pick<Alerts, "notify" | "sound">} */
function kept() {
  try {
    const { notify, sound } = JSON.parse(localStorage.getItem(KEY) ?? "{}");
    return { notify: notify === true, sound: sound === true };
  } catch {
    return { notify: false, sound: false };
  }
}

/** @param {Store} store @param {(page: import("../state/state.js").Page) => import("../i18n/i18n.js").Translate} texts */
export function createAlerts(store, texts) {
  const { send } = store;
  const icon = /** @type {HTMLLinkElement | null} */ (document.getElementById("icon"));
  const plain = icon?.getAttribute("href") ?? "";
  /** Browsers allow sound only after the first press on the page. @type {AudioContext | undefined} */ let audio;

  const permission = () => (isSecureContext && "Notification" in window ? Notification.permission : "insecure");

  function beep() {
    audio ??= new AudioContext();
    for (const { hertz, at_s } of TONES) {
      const tone = audio.createOscillator(), volume = audio.createGain();
      const from_s = audio.currentTime + at_s;
      tone.frequency.value = hertz;
      volume.gain.setValueAtTime(LOUDNESS, from_s);
      volume.gain.linearRampToValueAtTime(0, from_s + TONE_S);
      tone.connect(volume).connect(audio.destination);
      tone.start(from_s);
      tone.stop(from_s + TONE_S);
    }
  }

  /** @param {import("../state/state.js").Page} page */
  function showProgress(page) {
    const title = titleOf(page, texts(page));
    if (document.title !== title) document.title = title;
    const shown = iconOf(page) ?? plain;
    if (icon && icon.getAttribute("href") !== shown) icon.setAttribute("href", shown);
  }

  let before = store.page;
  /** @type {{ job: number, title: string } | null} */ let last = null;
  store.subscribe((page, message) => {
    last = page.station?.job ?? last;
    const news = newsOf(before, page, message, last, texts(page));
    before = page;
    if (["state", "closed", "hello", "language"].includes(message.type)) showProgress(page);
    if (!news) return;
    const { notify, sound } = page.alerts;
    if (sound) beep();
    // A new one replaces the last one of this page.
    if (notify && permission() === "granted") new Notification("Dobot", { body: news, tag: "dobot", icon: plain });
  });
  send({ type: "alerts", alerts: { ...kept(), permission: permission() } });

  /** @param {Partial<Alerts>} change */
  function set(change) {
    const alerts = { ...store.page.alerts, ...change };
    localStorage.setItem(KEY, JSON.stringify({ notify: alerts.notify, sound: alerts.sound }));
    send({ type: "alerts", alerts });
  }

  return {
    /** The browser is asked for its permission when a person wants notifications, and not before. @param {boolean} notify */
    async notify(notify) {
      if (notify && permission() === "default") await Notification.requestPermission();
      set({ notify: notify && permission() === "granted", permission: permission() });
    },
    /** @param {boolean} sound */
    sound(sound) {
      set({ sound });
      if (sound) beep();
    },
  };
}
