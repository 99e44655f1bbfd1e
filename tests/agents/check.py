"""Uses a virtual arm with the protocol's Python library: python check.py ADDRESS, as check.sh starts it."""

import asyncio
import json
import os
import subprocess
import sys
import urllib.request

from mcp import Client, StdioServerParameters
from mcp.types import ElicitResult

DOBOT = os.environ["DOBOT"]
ADDRESS = sys.argv[1].rstrip("/")
SQUARE = '<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm"><path d="M1 1h18v18h-18z" fill="none" stroke="black"/></svg>'
SLOW = {"svg": SQUARE, "options": {"place": {"pen_down": -40}, "tool": {"speed": 2}}}
# Each protocol version asks a person in its own way.
MODES = ["legacy", "auto"]


class Person:
    """The person at the agent's program, who answers every question alike."""

    def __init__(self, action):
        self.action, self.questions = action, []

    async def __call__(self, context, question):
        self.questions.append(question.message)
        return ElicitResult(action=self.action, content={} if self.action == "accept" else None)


def agent(*options, person=None, mode="auto"):
    program = StdioServerParameters(command=DOBOT, args=["mcp", *options], env={"DOBOT_DATA": os.environ["DOBOT_DATA"]})
    return Client(program, elicitation_callback=person, mode=mode)


def state():
    return json.load(urllib.request.urlopen(f"{ADDRESS}/api/v1/state", timeout=20))


def dobot(*words):
    subprocess.run([DOBOT, *words], check=True, capture_output=True)


def done(result):
    assert not result.is_error, result
    return result.structured_content


def refused(result, kind):
    assert result.is_error and result.structured_content["kind"] == kind, result
    return result.structured_content


async def tools_are_described_in_less_than_8_kb(mode):
    async with agent(mode=mode) as client:
        listed = await client.list_tools()
        size = len(json.dumps([it.model_dump(by_alias=True, exclude_none=True, mode="json") for it in listed.tools], separators=(",", ":")))
        assert size < 8000, size
        for tool in listed.tools:
            assert tool.title and tool.description and tool.output_schema["type"] == "object", tool
        # Nothing resets a stop or confirms a pose: a person has to look.
        names = {tool.name for tool in listed.tools}
        assert not any(word in name for name in names for word in ("reset", "confirm", "arm_laser")), names


async def resources_and_prompts_can_be_read(mode):
    async with agent(mode=mode) as client:
        for resource in (await client.list_resources()).resources:
            (content,) = (await client.read_resource(resource.uri)).contents
            assert resource.title and len(content.text) > 1, resource
        for prompt in (await client.list_prompts()).prompts:
            given = {it.name: "a house" for it in prompt.arguments}
            assert "a house" in (await client.get_prompt(prompt.name, given)).messages[0].content.text


async def a_person_is_asked_before_a_move(mode):
    for action in ("accept", "decline"):
        person = Person(action)
        before = state()["arm"]
        to = {"x_mm": 215 if before["x_mm"] < 210 else 200, "y_mm": 10, "z_mm": 30}
        async with agent(person=person, mode=mode) as client:
            moved = await client.call_tool("move_to", to)
        assert len(person.questions) == 1 and f"x {to['x_mm']}, y 10, z 30 mm" in person.questions[0], person.questions
        if action == "accept":
            assert abs(done(moved)["arm"]["x_mm"] - to["x_mm"]) < 0.1, moved
        else:
            refused(moved, "needs-a-person")
            assert state()["arm"]["x_mm"] == before["x_mm"]
    async with agent(mode=mode) as client:
        refused(await client.call_tool("move_to", to), "needs-a-person")


async def a_person_who_declines_leaves_no_job_and_one_who_accepts_starts_it(mode):
    for action in ("decline", "accept"):
        person = Person(action)
        before = {it["job"] for it in await jobs()}
        async with agent(person=person, mode=mode) as client:
            planned = done(await client.call_tool("plan_drawing", {"svg": SQUARE, "options": {"place": {"pen_down": -40}}}))
            drawn = await client.call_tool("draw", {"drawing": planned["drawing"], "wait_s": 600})
        assert len(person.questions) == 1 and "draw" in person.questions[0], person.questions
        new = [it for it in await jobs() if it["job"] not in before]
        if action == "accept":
            assert done(drawn)["job"]["phase"] == "done", drawn
            assert len(new) == 1, new
        else:
            refused(drawn, "needs-a-person")
            assert not new, new
    # Nobody can be asked: it waits for a person at the station.
    async with agent(mode=mode) as client:
        planned = done(await client.call_tool("plan_drawing", SLOW))
        queued = done(await client.call_tool("draw", {"drawing": planned["drawing"]}))["job"]
        assert queued["phase"] == "queued", queued
    dobot("jobs", "cancel", str(queued["job"]))


async def jobs():
    return json.load(urllib.request.urlopen(f"{ADDRESS}/api/v1/jobs", timeout=20))


async def cancel(client, job):
    """Cancels a job, and waits until the arm is free."""
    done(await client.call_tool("change_job", {"job": job, "action": "cancel"}))
    while done(await client.call_tool("look", {}))["job"]:
        pass


async def an_agent_cannot_resume_what_a_person_paused(mode):
    """Not even one whose program answers every question with yes."""
    person = Person("accept")
    async with agent("--may-move", person=person, mode=mode) as client:
        planned = done(await client.call_tool("plan_drawing", SLOW))
        job = done(await client.call_tool("draw", {"drawing": planned["drawing"], "wait_s": 0}))["job"]["job"]
        dobot("jobs", "pause")
        paused = done(await client.call_tool("jobs", {"job": job, "wait_s": 60}))["job"]
        assert paused["phase"] == "paused", paused
        refused(await client.call_tool("change_job", {"job": job, "action": "resume"}), "needs-a-person")
        assert not person.questions, person.questions
        await cancel(client, job)
        # What it paused itself, it may resume.
        job = done(await client.call_tool("draw", {"drawing": planned["drawing"], "wait_s": 0}))["job"]["job"]
        done(await client.call_tool("change_job", {"job": job, "action": "pause"}))
        done(await client.call_tool("jobs", {"job": job, "wait_s": 60}))
        done(await client.call_tool("change_job", {"job": job, "action": "resume", "wait_s": 0}))
        await cancel(client, job)


async def an_agent_cannot_confirm_for_a_person(mode):
    person = Person("accept")
    wait = """title = "swap"
[[steps]]
go = { x = 200, y = 0, z = 50 }
[[steps]]
wait = "put in the red pen"
[[steps]]
go = { x = 210, y = 0, z = 50 }
"""
    async with agent("--may-move", person=person, mode=mode) as client:
        job = done(await client.call_tool("run_program", {"program": {"text": wait}, "wait_s": 60}))["job"]
        # The list of jobs is a little behind.
        while not job["waits_for_person"]:
            job = done(await client.call_tool("jobs", {"job": job["job"]}))["job"]
        refused(await client.call_tool("change_job", {"job": job["job"], "action": "resume"}), "needs-a-person")
        await cancel(client, job["job"])
        # A stop that the agent has set holds until a person resets it.
        done(await client.call_tool("stop", {"reason": "trial"}))
        refused(await client.call_tool("move_to", {"x_mm": 200, "y_mm": 0, "z_mm": 30}), "stopped")
        assert state()["stop"], state()
        assert not person.questions, person.questions
    dobot("stop", "--reset")


async def progress_is_reported_to_who_asks(mode):
    reported = []

    async def see(progress, total, message):
        reported.append((progress, total))

    async with agent("--may-move", mode=mode) as client:
        planned = done(await client.call_tool("plan_drawing", SLOW))
        draw = {"drawing": planned["drawing"], "wait_s": 600}
        drawing = client.call_tool("draw", draw, progress_callback=see)
        done(await drawing)
    assert len(reported) > 1 and all(0 <= at <= total for at, total in reported), reported
    assert reported == sorted(reported), reported


async def over_http_an_agent_without_a_token_moves_nothing_and_asks_nobody(mode):
    person = Person("accept")
    async with Client(f"{ADDRESS}/mcp", elicitation_callback=person, mode=mode) as client:
        assert done(await client.call_tool("look", {}))["role"] == "queue"
        refused(await client.call_tool("move_to", {"x_mm": 200, "y_mm": 0, "z_mm": 30}), "needs-a-person")
    assert not person.questions, person.questions


CHECKS = [
    tools_are_described_in_less_than_8_kb,
    resources_and_prompts_can_be_read,
    a_person_is_asked_before_a_move,
    a_person_who_declines_leaves_no_job_and_one_who_accepts_starts_it,
    an_agent_cannot_resume_what_a_person_paused,
    an_agent_cannot_confirm_for_a_person,
    progress_is_reported_to_who_asks,
    over_http_an_agent_without_a_token_moves_nothing_and_asks_nobody,
]

for check in CHECKS:
    for mode in MODES:
        asyncio.run(asyncio.wait_for(check(mode), 600))
        print(f"python, {mode}: {check.__name__.replace('_', ' ')}", flush=True)
