// The stage alone, with a real pointer: that it shows what it is given, tells what is dragged, and does without WebGL.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { forward } from "../files/stage/kinematics.js";
import { CUP } from "../files/stage/sample.test.js";
import { drawn } from "./browser.mjs";
import { onScreen, openStage, reported } from "./stage_bench.mjs";

const PAPER = { from_mm: [150, -105], to_mm: [298, 105] };
const GHOST = { x_mm: 200, y_mm: -60, z_mm: 0, rotation_deg: 0, refused: false };
const WITH_ARM = { arm: reported(1), paper: PAPER, label: "the arm" };

let bench, page;

before(async () => {
  bench = await openStage({ reducedMotion: "reduce" });
  ({ page } = bench);
});
after(async () => {
  await bench.end();
  assert.deepEqual(bench.errors, []);
});

/** Gives the stage parts of a view and waits until they are drawn. */
async function show(parts) {
  await page.evaluate((parts) => window.show(parts), parts);
  await drawn(page);
}

const picture = async () => (await page.screenshot()).toString("base64");

/** Whether the picture changes by an action. */
async function changes(action) {
  const before = await picture();
  await action();
  return (await picture()) !== before;
}

const look = (preset) => page.evaluate((preset) => window.stage.look(preset), preset);
const targets = () => page.evaluate(() => window.targets.splice(0));

test("every part of a view changes the picture", async () => {
  await show(WITH_ARM);
  const parts = {
    arm: reported(2, -30),
    tool: { kind: "gripper", length_mm: 70 },
    laser: "burning",
    paper: null,
    marks: { width_mm: 0.5, ends_mm: [150, -50, 280, -50, 280, -50, 200, -90], shades: [1, 1] },
    things: [{ name: "cube", shape: { type: "box", size_mm: [25, 25, 25] }, color: "#c0392b", at_mm: [180, -100], turn_deg: 20, bottom_mm: 0 }],
    keepOuts: { camera: { box: { x_mm: [80, 140], y_mm: [-200, -120], z_mm: [-103, -20] } } },
    near: { limits: [], keep_outs: { camera: 0.8 } },
    planned: [[180, -80, 0], [280, 20, 10]],
    ghost: GHOST,
    draggable: true,
    dark: true,
    old: true,
    note: "0.8 s old",
  };
  for (const [name, value] of Object.entries(parts)) {
    assert.ok(await changes(() => show({ [name]: value })), name);
  }
});

test("a refused ghost does not look like an allowed one", async () => {
  await show({ ...WITH_ARM, dark: false, old: false, note: "", ghost: GHOST });
  assert.ok(await changes(() => show({ ghost: { ...GHOST, refused: true } })));
});

test("a limit is shown near it, and not away from it", async () => {
  await show({ arm: reported(30, 0, 30, 45), ghost: null, laser: "off", marks: null, things: [], keepOuts: {}, near: { limits: [], keep_outs: {} }, planned: null, draggable: false, tool: { kind: "suction_cup", length_mm: 40 } });
  const near = (limits) => ({ near: { limits, keep_outs: {} } });
  assert.equal(await changes(() => show(near([]))), false);
  assert.equal(await changes(() => show(near([{ quantity: "rear", bound: 32, closeness: 0.6 }]))), true);
  assert.equal(await changes(() => show(near([{ quantity: "z", bound: 136, closeness: 0.2 }]))), true);
  await show(near([]));
});

test("marks are added to the existing ones, and nothing is lost", async () => {
  const once = { width_mm: 1, ends_mm: [160, -90, 280, -90, 280, -90, 280, 90, 280, 90, 160, 90], shades: [1, 1, 1] };
  await show({ marks: once });
  const whole = await picture();
  await page.evaluate((all) => {
    window.grown = { ...all, ends_mm: [], shades: [] };
    window.show({ marks: window.grown });
    for (const n of [0, 1, 2]) {
      window.grown.ends_mm.push(...all.ends_mm.slice(4 * n, 4 * n + 4));
      window.grown.shades.push(1);
      window.show({ marks: window.grown });
    }
  }, once);
  await drawn(page);
  assert.equal(await picture(), whole);
});

test("nothing is drawn while nothing changes, even if an arm at rest keeps reporting", async () => {
  const resting = { rear_deg: 30, fore_deg: 45, servo_deg: 0, base_deg: 20, suction: false, gripper_deg: 0 };
  await show({ marks: null, arm: { ...resting, at_s: 50 } });
  await show({ arm: { ...resting, at_s: 50.08 } });
  await drawn(page);
  const frames = await page.evaluate(async (resting) => {
    let asked = 0;
    const kept = window.requestAnimationFrame;
    window.requestAnimationFrame = (action) => (asked += 1, kept.call(window, action));
    for (let n = 1; n <= 5; n += 1) window.show({ arm: { ...resting, at_s: 51 + n * 0.08 }, tool: { kind: "suction_cup", length_mm: 40 } });
    for (let n = 0; n < 5; n += 1) await new Promise((done) => kept.call(window, done));
    window.requestAnimationFrame = kept;
    return asked;
  }, resting);
  assert.equal(frames, 0);
});

test("nothing is drawn while the stage is out of sight, and changes meanwhile are visible when it is back", async () => {
  await show({ arm: reported(60, 20) });
  await page.evaluate(() => {
    document.querySelector("#stage").style.setProperty("display", "none");
    // Observers are called in the order of their creation: after this one, that of the stage was called.
    return new Promise((done) => {
      const observer = new IntersectionObserver(([stage]) => stage.isIntersecting || done(observer.disconnect()));
      observer.observe(document.querySelector("#stage"));
    });
  });
  await drawn(page);
  const asked = await page.evaluate(async (arm) => {
    let asked = 0;
    const kept = window.requestAnimationFrame;
    window.requestAnimationFrame = (action) => (asked += 1, kept.call(window, action));
    window.show({ arm });
    for (let n = 0; n < 5; n += 1) await new Promise((done) => kept.call(window, done));
    window.requestAnimationFrame = kept;
    return asked;
  }, reported(61, -40));
  assert.equal(asked, 0);
  await page.evaluate(() => document.querySelector("#stage").style.removeProperty("display"));
  await drawn(page);
  const back = await picture();
  await show({ arm: reported(62, -40) });
  assert.equal(await picture(), back);
});

test("after the last status the arm is at its reported place, for any earlier motion", async () => {
  for (const [n, base_deg] of [0, 8, 16, 24].entries()) await page.evaluate((arm) => window.show({ arm }), reported(40 + 0.08 * n, base_deg));
  await drawn(page);
  const end = await picture();
  await show({ arm: reported(40.4, 24) });
  assert.equal(await picture(), end);
});

test("each camera preset shows a different view, and so do drag, wheel and keys", async () => {
  await show(WITH_ARM);
  const seen = new Set();
  for (const key of ["1", "2", "3", "4"]) {
    await page.focus("#stage");
    await page.keyboard.press(key);
    await drawn(page);
    seen.add(await picture());
  }
  assert.equal(seen.size, 4);
  await look("iso");
  await drawn(page);
  const hands = {
    async orbit() {
      await page.mouse.move(150, 150);
      await page.mouse.down();
      await page.mouse.move(250, 180);
      await page.mouse.up();
    },
    async pan() {
      await page.mouse.move(150, 150);
      await page.mouse.down({ button: "right" });
      await page.mouse.move(180, 190);
      await page.mouse.up({ button: "right" });
    },
    zoom: () => page.mouse.wheel(0, 240),
    turn: () => page.keyboard.press("Shift+ArrowLeft"),
    shift: () => page.keyboard.press("Control+ArrowUp"),
    nearer: () => page.keyboard.press("+"),
  };
  for (const [name, action] of Object.entries(hands)) {
    assert.ok(await changes(async () => (await action(), await drawn(page))), name);
  }
  assert.deepEqual(await targets(), []);
});

test("the target is dragged over the table by its tip, in millimetres", async () => {
  await show({ ...WITH_ARM, ghost: GHOST, draggable: true });
  await look("top");
  await drawn(page);
  const from = onScreen("top", GHOST);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(from.x + 60, from.y, { steps: 5 });
  await page.mouse.up();
  const told = await targets();
  const last = told.at(-1), dragged = told.at(-2);
  assert.equal(last.phase, "drop");
  assert.equal(dragged.phase, "drag");
  // To the right on the screen is to the right of the arm, -Y; the height stays.
  assert.ok(last.y_mm < GHOST.y_mm - 20, JSON.stringify(last));
  assert.ok(Math.abs(last.x_mm - GHOST.x_mm) < 3, JSON.stringify(last));
  assert.equal(last.z_mm, GHOST.z_mm);
  assert.equal(last.rotation_deg, GHOST.rotation_deg);
});

test("a target is dragged from its new place before a frame shows it there", async () => {
  await show({ ...WITH_ARM, ghost: { ...GHOST, y_mm: 60 }, draggable: true });
  await look("top");
  await drawn(page);
  await page.evaluate((ghost) => {
    const request = window.requestAnimationFrame;
    window.requestAnimationFrame = () => 0;
    window.goOn = () => void (window.requestAnimationFrame = request);
    window.show({ ghost });
  }, GHOST);
  const { x, y } = onScreen("top", GHOST);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 5 });
  await page.mouse.up();
  const last = (await targets()).at(-1);
  await page.evaluate(() => window.goOn());
  assert.equal(last?.phase, "drop");
  assert.ok(last.y_mm < GHOST.y_mm - 20 && Math.abs(last.x_mm - GHOST.x_mm) < 3, JSON.stringify(last));
});

test("the camera stops where a target is grabbed", async () => {
  await show({ ...WITH_ARM, ghost: GHOST, draggable: true });
  await look("top");
  await drawn(page);
  const { x, y } = onScreen("top", GHOST);
  await page.mouse.move(x, y);
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await look("iso");
  await page.mouse.down();
  // Longer than the camera would take to arrive.
  await page.evaluate(async () => {
    for (let n = 0; n < 60; n += 1) await new Promise((done) => requestAnimationFrame(done));
  });
  await page.mouse.move(x + 60, y, { steps: 5 });
  await page.mouse.up();
  await page.emulateMedia({ reducedMotion: "reduce" });
  const last = (await targets()).at(-1);
  assert.equal(last?.phase, "drop");
  assert.ok(last.y_mm < GHOST.y_mm - 20 && Math.abs(last.x_mm - GHOST.x_mm) < 12, JSON.stringify(last));
});

test("without a ghost the arm's own tool can be dragged, but not where dragging is disabled", async () => {
  await show({ ...WITH_ARM, arm: reported(50, 0), ghost: null, draggable: true });
  await look("top");
  await drawn(page);
  const from = onScreen("top", forward(reported(50, 0), CUP));
  const pull = async () => {
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(from.x + 40, from.y + 10, { steps: 3 });
    await page.mouse.up();
    return targets();
  };
  assert.equal((await pull()).at(-1)?.phase, "drop");
  await show({ draggable: false });
  assert.deepEqual(await pull(), []);
});

test("in the side view, the tip is dragged up and down, too", async () => {
  await show({ ...WITH_ARM, ghost: GHOST, draggable: true });
  await look("side");
  await drawn(page);
  const at = onScreen("side", GHOST);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x, at.y - 40, { steps: 4 });
  await page.mouse.up();
  const last = (await targets()).at(-1);
  assert.ok(last.z_mm > GHOST.z_mm + 10 && Math.abs(last.x_mm - GHOST.x_mm) < 3, JSON.stringify(last));
});

test("fingers work, too: one turns, two zoom, and one on the target drags it", async () => {
  const phone = await openStage({ viewport: { width: 390, height: 340 }, hasTouch: true, isMobile: true, reducedMotion: "reduce" });
  const { page: glass } = phone;
  const touch = await glass.context().newCDPSession(glass);
  const send = (type, ...points) => touch.send("Input.dispatchTouchEvent", { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const seen = async () => {
    await drawn(glass);
    return (await glass.screenshot()).toString("base64");
  };
  try {
    await glass.evaluate((parts) => window.show(parts), { ...WITH_ARM, ghost: GHOST, draggable: true });
    const first = await seen();
    await send("touchStart", [40, 60]);
    await send("touchMove", [120, 80]);
    await send("touchEnd");
    const turned = await seen();
    assert.notEqual(turned, first);
    await send("touchStart", [150, 60], [200, 60]);
    await send("touchMove", [100, 60], [250, 60]);
    await send("touchEnd");
    assert.notEqual(await seen(), turned);
    assert.deepEqual(await glass.evaluate(() => window.targets), []);
    await glass.evaluate(() => window.stage.look("top"));
    await seen();
    const { x, y } = onScreen("top", GHOST, { width: 390, height: 340 });
    await send("touchStart", [x, y]);
    await send("touchMove", [x - 20, y]);
    await send("touchEnd");
    const told = await glass.evaluate(() => window.targets);
    assert.equal(told.at(-1).phase, "drop");
    assert.ok(told.at(-1).y_mm > GHOST.y_mm + 10, JSON.stringify(told));
    assert.deepEqual(phone.errors, []);
  } finally {
    await phone.end();
  }
});

test("in a window of another shape the whole arm is visible, and the drag handle is at its place", async () => {
  await show({ ...WITH_ARM, arm: reported(55, 0), ghost: GHOST, draggable: true });
  await look("top");
  for (const size of [{ width: 350, height: 560 }, { width: 700, height: 490 }]) {
    await page.setViewportSize(size);
    await drawn(page);
    const { x, y } = onScreen("top", GHOST, size);
    await page.mouse.move(x, y);
    assert.ok(await page.evaluate(() => document.querySelector("canvas").classList.contains("is-over-handle")), JSON.stringify(size));
  }
});

test("while the window changes its size, the picture is never black", async () => {
  const sized = await openStage();
  await sized.page.evaluate((parts) => window.show(parts), WITH_ARM);
  const black = await sized.page.evaluate(async (view) => {
    const element = document.querySelector("#stage"), canvas = element.querySelector("canvas"), pen = canvas.getContext("2d");
    let black = 0;
    for (let n = 0; n < 60; n += 1) {
      // While one frame is still being drawn, and while none is.
      if (n % 8 < 4) element.style.height = `${300 + n}px`;
      window.show({ arm: { ...view.arm, base_deg: n } });
      await new Promise((done) => requestAnimationFrame(done));
      black += Number(pen.getImageData(3, 3, 1, 1).data.slice(0, 3).every((value) => value === 0));
    }
    return black;
  }, WITH_ARM);
  await sized.end();
  assert.equal(black, 0);
});

test("after a lost graphics context the view has two dimensions, and three when it is restored", async () => {
  await show({ ...WITH_ARM, ghost: null, draggable: false });
  const kind = () => page.evaluate(() => document.querySelector("#stage").dataset.shown);
  assert.equal(await kind(), "3d");
  await page.evaluate(() => {
    window.card = window.gl.getExtension("WEBGL_lose_context");
    window.card.loseContext();
  });
  await page.waitForFunction(() => document.querySelector("#stage").dataset.shown === "2d");
  assert.ok(await changes(() => show({ arm: reported(60, 50) })));
  await page.evaluate(() => window.card.restoreContext());
  await page.waitForFunction(() => document.querySelector("#stage").dataset.shown === "3d");
  assert.ok(await changes(() => show({ arm: reported(70, -50) })));
  assert.deepEqual(await page.evaluate(() => window.shown), ["3d", "2d", "3d"]);
});

test("a browser without WebGL shows the arm in two dimensions, and drags it", async () => {
  const flat = await openStage({ webgl: false, viewport: { width: 1000, height: 700 } });
  try {
    const kind = await flat.page.evaluate(() => document.querySelector("#stage").dataset.shown);
    assert.equal(kind, "2d");
    await flat.page.evaluate((parts) => window.show(parts), { ...WITH_ARM, ghost: GHOST, draggable: true });
    await drawn(flat.page);
    // From above, in the left half: 700 mm wide, 500 mm tall.
    const scale = Math.min(500 / 700, 700 / 590) * 0.94;
    const at = { x: 250 + -GHOST.y_mm * scale, y: 350 - (GHOST.x_mm - 50) * scale };
    await flat.page.mouse.move(at.x, at.y);
    await flat.page.mouse.down();
    await flat.page.mouse.move(at.x - 30, at.y, { steps: 3 });
    await flat.page.mouse.up();
    const last = (await flat.page.evaluate(() => window.targets)).at(-1);
    assert.equal(last.phase, "drop");
    assert.ok(Math.abs(last.y_mm - (GHOST.y_mm + 30 / scale)) < 1, JSON.stringify(last));
    assert.equal(last.z_mm, GHOST.z_mm);
    assert.deepEqual(flat.errors, []);
  } finally {
    await flat.end();
  }
});
