// The files that the station stores, as a card of the panels that use them.

import { html, nothing } from "../vendor/lit-html/lit-html.js";
import { live } from "../vendor/lit-html/directives/live.js";
import { repeat } from "../vendor/lit-html/directives/repeat.js";
import { sketchPicture } from "../parts/sketch.js";
import { fileKey, shownFiles } from "../state/files.js";
import { formatSize } from "../i18n/i18n.js";
import { problemText } from "../i18n/problem_text.js";

/** @typedef {import("../views/context.js").Context} Context */
/** @typedef {import("../state/files.js").StoredFile} StoredFile */

/** @param {Context} context @param {boolean} programs whether programs are listed, or drawings and photos */
export function files(context, programs) {
  const { page, t, act } = context;
  const { list, search } = page.files;
  const shown = shownFiles(page.files, programs);
  return html`
    <section class="card files" aria-labelledby="files-title">
      <h2 id="files-title">${t(programs ? "files.programs" : "files.drawings")}</h2>
      ${question(context)}${problem(context)}
      <input id="files-search" type="search" autocomplete="off" aria-label=${t("files.search")} placeholder=${t("files.search")} .value=${live(search)} @input=${(/** @type {Event} */ event) => act.send({ type: "files_search", text: /** @type {HTMLInputElement} */ (event.target).value })}>
      ${list && !shown.length ? html`<p id="files-none" class="quiet">${t(search ? "files.none_found" : "files.none")}</p>` : nothing}
      <ul class="jobs shelf">${repeat(shown, ({ file }) => file, (file) => entry(context, file))}</ul>
      ${list ? html`<p id="files-space" class="quiet">${t("files.space", { used: formatSize(list.used_bytes), most: formatSize(list.most_bytes), files: list.most_files })}</p>` : nothing}
      ${list?.damaged.map((why) => html`<p class="status" data-tone="warn">${why}</p>`) ?? nothing}
    </section>`;
}

/** Another file has this name. @param {Context} context */
function question({ page, t, act }) {
  const { taken } = page.files;
  if (!taken) return nothing;
  return html`
    <div id="file-taken" class="status" data-tone="warn" role="alert">
      <p>${t("files.taken", { name: taken.file.name })}</p>
      <div class="row">
        <button id="file-replace" type="button" class="small" @click=${() => void act.files.answer("replace")}>${t("files.replace")}</button>
        <button id="file-keep-both" type="button" class="small strong" @click=${() => void act.files.answer("keep_both")}>${t("files.keep_both")}</button>
        <button id="file-not" type="button" class="small" @click=${() => void act.files.answer(null)}>${t("files.not")}</button>
      </div>
    </div>`;
}

/** @param {Context} context */
function problem({ page, t }) {
  const { problem } = page.files;
  return problem ? html`<p id="files-problem" class="status" data-tone="bad" role="alert">${problemText(t, problem)}</p>` : nothing;
}

/** @param {Context} context @param {StoredFile} file */
function entry({ page, t, act }, file) {
  const { name, bytes, changed_ms, last_job } = file;
  const button = (/** @type {string} */ id, /** @type {string} */ word, /** @type {() => void} */ does) => html`<button type="button" class="small" data-act=${id} aria-label=${`${word}: ${name}`} @click=${does}>${word}</button>`;
  const asks = page.files.removes === file.file;
  return html`
    <li class="entry pictured" data-file=${file.file} aria-current=${page.draw.stored?.file === file.file ? "true" : "false"}>
      ${sketchPicture(page.files.sketches[fileKey(file)], t("files.picture", { name }))}
      <div>
        <p class="head"><strong class="name">${name}</strong></p>
        <p class="quiet">${formatSize(bytes)} · ${new Date(changed_ms).toLocaleDateString(page.language)}${last_job ? html` · ${t("files.last", { job: last_job.job })} ${t(`job.${last_job.phase}`)}` : nothing}</p>
        ${file.problem ? html`<p class="quiet">${file.problem}</p>` : nothing}
        <div class="row">${asks ? html`
          <span>${t("files.remove.sure")}</span>
          ${button("remove-yes", t("files.remove"), () => void act.files.remove(file.file))}
          ${button("remove-no", t("no"), () => act.send({ type: "file_removes", file: null }))}` : html`
          ${button("open", t("files.open"), () => act.openStored(file))}
          ${button("download", t("files.download"), () => void act.files.download(file))}
          ${button("remove", t("files.remove_ask"), () => act.send({ type: "file_removes", file: file.file }))}`}
        </div>
      </div>
    </li>`;
}

/** Somebody else placed the drawing elsewhere. @param {Context} context */
export function theirs({ page, t, act }) {
  if (!page.files.theirs) return nothing;
  return html`
    <div id="file-theirs" class="status" data-tone="warn" role="alert">
      <p>${t("files.theirs", { name: page.files.theirs.name })}</p>
      <div class="row">
        <button id="theirs-use" type="button" class="small" @click=${() => act.files.settle(true)}>${t("files.theirs.use")}</button>
        <button id="theirs-keep" type="button" class="small" @click=${() => act.files.settle(false)}>${t("files.theirs.keep")}</button>
      </div>
    </div>`;
}
