// The recordings of the station: a list of files, and a player that shows them on the stage.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { SPEEDS, extent } from "../state/recordings.js";
import { problemText } from "../i18n/problem_text.js";
import { formatClock, formatSize } from "../i18n/i18n.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/recordings.js").RecordingView} RecordingView */

/** @param {Context} context */
export function recordings(context) {
  const { page, t } = context;
  const { all, problem, chosen } = page.recordings;
  return html`
    <section class="card" aria-labelledby="recordings-title">
      <h2 id="recordings-title">${t("recordings")}</h2>
      ${problem ? html`<p id="recordings-problem" class="status" data-tone="bad" role="alert">${problemText(t, problem)}</p>` : nothing}
      ${chosen ? player(context) : nothing}
      ${all?.length === 0 ? html`<p class="drop quiet">${t("recordings.none")}</p>` : nothing}
      <ol class="jobs">${repeat([...(all ?? [])].reverse(), ({ name }) => name, (recording) => entry(context, recording))}</ol>
      <p class="quiet">${t("recordings.hint")}</p>
    </section>`;
}

/** @param {Context} context @param {RecordingView} recording */
function entry({ page, t, act }, { name, begin_ms, bytes, being_written }) {
  const begin = new Date(begin_ms).toLocaleString(page.language);
  return html`
    <li class="entry" data-recording=${name} aria-current=${name === page.recordings.chosen ? "true" : "false"}>
      <p class="head"><strong class="name">${begin}</strong> ${being_written ? html`<span class="chip" data-tone="good">${t("recordings.now")}</span>` : nothing}</p>
      <div class="row">
        <button type="button" class="small" data-act="show" aria-label=${`${t("recordings.show")}: ${begin}`} @click=${() => void act.recordings.open(name)}>${t("recordings.show")}</button>
        <button type="button" class="small" data-act="save" aria-label=${`${t("recordings.save")}: ${begin}`} @click=${() => void act.recordings.save(name)}>${t("recordings.save")}</button>
        <span class="quiet">${formatSize(bytes)}</span>
      </div>
    </li>`;
}

/** @param {Context} context */
function player({ page, t, act }) {
  const { states, at_s, played_ms, speed } = page.recordings;
  if (!states) return html`<p id="player-reads" class="quiet" role="status">${t("recordings.reading")}</p>`;
  const { from_s, to_s } = extent(page.recordings);
  if (!states.samples.length) return html`<p id="player-empty" class="quiet" role="status">${t("recordings.empty")}</p>`;
  const scrub = (/** @type {Event} */ event) => act.send({ type: "recording_at", at_s: Number(/** @type {HTMLInputElement} */ (event.target).value) });
  const plays = played_ms !== null;
  const time = states.begin_ms == null ? "" : new Date(states.begin_ms + at_s * 1000).toLocaleTimeString(page.language);
  return html`
    <div id="player" class="player">
      <input id="player-time" type="range" min=${from_s} max=${to_s} step="any" aria-label=${t("recordings.time")} aria-valuetext=${`${formatClock(at_s - from_s)} / ${formatClock(to_s - from_s)}`} .value=${live(String(at_s))} @input=${scrub}>
      <p class="quiet ends"><output id="player-at" for="player-time">${formatClock(at_s - from_s)}</output><span>${time}</span><span>${formatClock(to_s - from_s)}</span></p>
      <div class="row">
        <button id="player-play" type="button" class="small strong" @click=${() => act.send({ type: "recording_plays", now_ms: plays ? null : Date.now() })}>${t(plays ? "play.pause" : "play.play")}</button>
        <fieldset class="segments">
          <legend class="unseen">${t("play.speed")}</legend>
          ${SPEEDS.map((factor) => html`<label><input type="radio" name="player-speed" value=${factor} .checked=${live(factor === speed)} @change=${() => act.send({ type: "recording_speed", speed: factor })}><span>${factor}×</span></label>`)}
        </fieldset>
      </div>
      ${states.spacing_s > 0 ? html`<p class="quiet">${t("recordings.thinned", { s: states.spacing_s.toFixed(1) })}</p>` : nothing}
    </div>`;
}
