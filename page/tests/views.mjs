// Every view of the page, and how a person gets there: for the pictures, and for the test that a screen reader gets along.

export const SIZES = { desktop: { width: 1440, height: 900 }, tablet: { width: 1024, height: 768 }, phone: { width: 390, height: 844 } };
export const THEMES = ["light", "dark"];
export const LANGUAGES = ["en", "de", "zh"];
const LOCALES = { en: "en-GB", de: "de-DE", zh: "zh-CN" };

const tab = (name) => async (page) => {
  await page.click(`#tab-${name}`);
};
const confirm = async (page) => {
  if (!(await page.isVisible("#confirm-pose"))) return;
  await page.click("#confirm-pose");
  await page.click("#confirm-yes");
  await page.waitForSelector("#confirm-pose", { state: "detached" });
};

/** A name, and what leads to it from the page as it was opened. */
export const VIEWS = {
  first: async () => {},
  tour: async (page) => {
    await page.click("#first-tour");
    await page.waitForSelector("#lesson-text");
  },
  question: async (page) => {
    await page.click("#first-close");
    await page.click("#arm-laser, #confirm-pose");
    await page.waitForSelector("#confirm-yes");
  },
  move: async (page) => {
    await page.click("#first-close");
    await confirm(page);
    for (const id of ["pads", "speeds", "voice"]) await page.click(`#${id} > summary`);
  },
  target: async (page) => {
    await page.click("#first-close");
    await confirm(page);
    await page.fill("#target-x_mm", "600");
    await page.waitForSelector("#target-nearest");
  },
  draw: async (page) => {
    await page.click("#first-close");
    await page.click("#tab-draw");
    await page.check("#draw-title ~ .segments input[value=text]", { force: true });
    await page.fill("#draw-text", "Hello");
    await page.waitForSelector("#preview");
  },
  teach: async (page) => {
    await page.click("#first-close");
    await confirm(page);
    await page.click("#tab-teach");
    await page.click("#capture");
    await page.waitForSelector("#step-0");
    await page.click("#teach-pause");
    await page.waitForSelector("#step-1");
  },
  jobs: async (page) => {
    await page.evaluate(async () => {
      const go = { type: "move_to", x_mm: 200, y_mm: 0, z_mm: 50, rotation_deg: 0, suction: false, mode: "movj", gripper_deg: 0, pause_s: 0 };
      for (const title of ["harbour.svg", "there and back"]) {
        const body = JSON.stringify({ title, kind: "program", commands: [go] });
        await fetch("api/v1/jobs", { method: "POST", headers: { "content-type": "application/json" }, body });
      }
    });
    await tab("jobs")(page);
    await page.waitForSelector(".entry");
  },
  recording: async (page) => {
    await tab("jobs")(page);
    await page.click("[data-recording] [data-act=show]");
    await page.waitForSelector("#player");
  },
  watch: tab("watch"),
  packets: async (page) => {
    await tab("watch")(page);
    await page.click("#packets > summary");
    await page.waitForSelector(".packets li");
    await page.locator("#packets-pause").scrollIntoViewIfNeeded();
  },
  set_up: tab("set_up"),
  calibrate: async (page) => {
    await tab("set_up")(page);
    await confirm(page);
    await page.click("#calibrate-begin");
    await page.fill("#calibrate-number", "417");
    await page.fill("#calibrate-bar", "189.5");
    await page.click("#calibrate-next");
    // Anywhere: what the touches tell is a problem then, which is shown, too.
    for (let touch = 0; touch < 4; touch += 1) await page.click("#calibrate-touch");
    await page.waitForSelector("#calibrate .status:visible");
  },
  paper: async (page) => {
    await tab("set_up")(page);
    await confirm(page);
    await page.click("#paper-begin");
    await page.click("#paper-touch");
    await page.locator("#paper").scrollIntoViewIfNeeded();
  },
  stopped: async (page) => {
    await page.click("#first-close");
    await page.keyboard.press("Escape");
    await page.waitForSelector("#stopped");
  },
};

/** A context of a browser for a look, and what ends it. */
export const look = ({ size, theme, language }) => ({ viewport: SIZES[size], colorScheme: theme, locale: LOCALES[language], hasTouch: size === "phone", reducedMotion: "reduce" });
