use dobot_motion::Model;
use dobot_safety::Policy;
use dobot_teach::{NoFiles, Program, ProgramDocument, check};
use dobot_wire::{Dialect, Status};

/// A program that anybody writes: an error with its line, or a program that is written and read again unchanged, that
/// is made into commands or refused, and that is checked without a panic.
pub fn programs(input: &[u8]) {
    let text = crate::spelled(input, WORDS);
    let text = String::from_utf8_lossy(&text);
    let program = match Program::from_toml(&text) {
        Ok(program) => program,
        Err(error) => {
            assert!(!error.to_string().contains('\n'));
            return;
        }
    };
    let again = Program::from_toml(&program.to_toml());
    assert_eq!(again.expect("what was written can be read"), program);
    if let Ok(document) = ProgramDocument::new(&text) {
        assert_eq!(document.program().expect("it was read before"), program);
    }
    let Ok(compiled) = program.compile(&mut NoFiles) else {
        return;
    };
    assert!(compiled.commands.len() <= 1_000_000);
    let job = compiled.job();
    job.program
        .check(job.commands.len())
        .expect("a job takes it");
    if compiled.commands.len() <= MAX_CHECKED {
        let start = Model::new(Dialect::FIRMWARE_1_1, &Status::AT_ZERO);
        let report = check(&compiled, &Policy::default(), start);
        assert!(report.steps_s.iter().all(|step_s| step_s.is_finite()));
        assert_eq!(report.steps_s.len(), compiled.steps.len());
    }
}

/// As many are looked at quickly enough.
const MAX_CHECKED: usize = 1000;

const WORDS: &[&str] = &[
    "title = \"a\"\n",
    "start_speed_percent = 20\n",
    "[points]\n",
    "a = { x = 200, y = 0, z = 0 }\n",
    "b = { base = 0, rear = 45, fore = 45 }\n",
    "c = { x = 5, y = 5, z = 0, frame = \"f\" }\n",
    "[frames.f]\norigin = \"a\"\nx = { x = 230, y = 0, z = 0 }\ny = { x = 200, y = 30, z = 0 }\n",
    "[grids.g]\nat = \"a\"\ncolumns = 3\nrows = 2\npitch = { x = 10, y = 10 }\n",
    "[tools.t]\nkind = \"gripper\"\nlength = 20\n",
    "[[steps]]\n",
    "[[steps.steps]]\n",
    "[[steps.steps.steps]]\n",
    "go = \"a\"\n",
    "go = \"b\"\n",
    "go = \"c\"\n",
    "go = \"g\"\n",
    "go = { x = 220, y = 10, z = 10, rotation = 10 }\n",
    "path = \"movl\"\n",
    "path = \"movj\"\n",
    "offset = { z = 10 }\n",
    "suction = true\n",
    "gripper = 45\n",
    "pause = 0.5\n",
    "laser = true\n",
    "laser = false\n",
    "wait = \"now\"\n",
    "speed = { percent = 30 }\n",
    "speed = { line = 50, jump_height = 30 }\n",
    "tool = \"t\"\n",
    "repeat = 3\n",
    "repeat = 1000000000\n",
    "repeat = \"forever\"\n",
    "each = \"g\"\n",
    "each = [\"g\", \"g\"]\n",
    "call = \"a.toml\"\n",
    "arc = { through = \"a\", to = \"c\" }\n",
    "circle = { through = { x = 210, y = 10, z = 0 }, to = { x = 220, y = 0, z = 0 }, tolerance = 0.1 }\n",
    "drawing = { file = \"a.svg\", pen_down = -40 }\n",
    "steps = [{ go = \"a\" }, { pause = 1 }]\n",
    "nan",
    "-inf",
    "1e9",
    "{",
    "}",
    "[",
    "]",
    ",",
    "=",
    "\"",
    "#",
    ".",
    "\n",
    " ",
    "0",
];
