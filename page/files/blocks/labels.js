// The words on the blocks. What has no word here is shown as its key, with the description of the schema: a new key needs none.

/** @typedef {import("../i18n/i18n.js").Language} Language */
/** @typedef {keyof typeof GROUPS} Group */

/** The groups of the toolbox, with the verbs and entries in each; the rest is in the last one. */
export const GROUPS = {
  moves: ["step go", "step arc", "step circle", "step drawing"],
  grips: ["step pick", "step place", "step here"],
  repeats: ["step repeat", "step each", "step while", "step call"],
  asks: ["step choose", "item When", "step wait", "step barrier"],
  sets: ["step speed", "step tool", "step laser", "step set", "step add"],
  names: ["entry Point", "entry Grid", "entry Frame", "entry MountedTool", "entry integer"],
  more: /** @type {string[]} */ ([]),
};

/** Words of types and keys that differ from the key itself. @type {Record<Language, Record<string, string>>} */
const WORDS = {
  en: {
    program: "program", here: "here", "item When": "answer", "entry Point": "point", "entry Grid": "grid", "entry Frame": "frame", "entry MountedTool": "tool", "entry integer": "variable",
    go: "go to", pick: "pick up at", place: "put down at", each: "for each cell of", call: "call program", arc: "arc", drawing: "draw", choose: "ask", repeat: "repeat", wait: "wait for a person",
    barrier: "wait for the other arms at", set: "set", add: "add", start_speed_percent: "first motion, %", on_missed: "if it was missed", pen_down: "pen height", acceleration_percent: "acceleration, %", percent: "%",
    joint_acceleration: "joint acceleration", servo_acceleration: "servo acceleration", line_acceleration: "line acceleration", jump_height: "jump height", when: "answers", from: "given as", otherwise: "otherwise",
    true: "on", false: "off", suction_cup: "suction cup",
  },
  zh: {
    program: "程序", here: "在此处", "item When": "答案", "entry Point": "点", "entry Grid": "阵列", "entry Frame": "坐标系", "entry MountedTool": "工具", "entry integer": "变量",
    go: "移动到", pick: "拾取于", place: "放置于", laser: "激光", wait: "等待人员", barrier: "等待其他机械臂于", speed: "速度", tool: "工具", repeat: "重复", each: "遍历每一格", call: "调用程序", arc: "圆弧", circle: "整圆", drawing: "绘图",
    choose: "提问", set: "设置", add: "增加", while: "当", steps: "步骤", title: "标题", start_speed_percent: "首次运动 %", points: "点", grids: "阵列", frames: "坐标系", tools: "工具", variables: "变量",
    path: "路径", offset: "偏移", suction: "吸盘", gripper: "夹爪", pause: "暂停", by: "由谁回答", every: "每第几次", timeout: "超时", otherwise: "否则", when: "答案", answer: "答案", approach: "接近高度", retreat: "退回高度", settle: "稳定时间", on_missed: "如未拾到", retries: "重试",
    rotation: "旋转", frame: "坐标系", base: "底座", rear: "大臂", fore: "小臂", servo: "舵机", from: "运行时给定", kind: "类型", length: "长度", origin: "原点", at: "首格", columns: "列", rows: "行", layers: "层", pitch: "间距", through: "经过", to: "到", tolerance: "容差",
    file: "文件", pen_down: "落笔高度", options: "选项", percent: "%", acceleration_percent: "加速度 %", joint: "关节", joint_acceleration: "关节加速度", servo_acceleration: "舵机加速度", line: "直线", line_acceleration: "直线加速度", jump_height: "跳跃高度",
    true: "开", false: "关", forever: "一直", person: "人", seen: "看到的", skip: "跳过", jump: "跳跃", movl: "直线", movj: "关节", suction_cup: "吸盘", pen: "笔",
  },
};

/** The word for a type or a key. @param {Language} language @param {string} key */
export const wordOf = (language, key) => WORDS[language][key] ?? key.replace(/^\w+ /, "").replaceAll("_", " ");

/** The group of a type of blocks. @param {string} type @returns {Group} */
export const groupOf = (type) => /** @type {Group} */ (Object.keys(GROUPS).find((group) => GROUPS[/** @type {Group} */ (group)].includes(type)) ?? "more");

/** All words, for the test. */
export const words = () => WORDS;
