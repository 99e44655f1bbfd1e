// The stage without the page around it: a test gives views, and reads what a person does.
import { createStage } from "/stage/stage.js";
import { EMPTY } from "/stage/view.js";

const element = document.querySelector("#stage");
const stage = createStage(element);
const targets = [], shown = [];
let view = EMPTY;

element.addEventListener("target", (event) => targets.push(event.detail));
element.addEventListener("shown", (event) => shown.push(event.detail));

Object.assign(window, {
  stage, targets, shown,
  /** Changes parts of the view. */
  show(parts) {
    view = { ...view, ...parts };
    stage.show(view);
  },
});
