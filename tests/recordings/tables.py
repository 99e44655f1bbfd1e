"""Checks the tables and the dataset that `dobot log --export` makes of a recording, with readers of others.

python tests/recordings/tables.py FOLDER

The folder holds a recording (*.mcap), run.csv, run.parquet, their commands beside them, and the dataset `dataset`.
What they should hold is read from the recording with PyPI's `mcap`.
"""

import json
import math
import pathlib
import sys

import datasets
import numpy as np
import pandas as pd
import pyarrow.parquet as pq
from mcap.reader import make_reader

STATE = ["base_deg", "rear_deg", "fore_deg", "servo_deg", "suction", "gripper_deg"]
POSE = ["x_mm", "y_mm", "z_mm", "rotation_deg"]


def main(folder):
    (recording,) = folder.glob("*.mcap")
    statuses, commands = read(recording)
    check_statuses(folder, statuses)
    check_commands(folder, commands)
    episodes = check_dataset(folder / "dataset", statuses)
    print(f"{len(statuses)} statuses and {len(commands)} commands in CSV and Parquet, {episodes} episodes of a dataset")


def read(recording):
    """All statuses and all commands, with their times in nanoseconds since 1970."""
    statuses, commands = [], []
    with recording.open("rb") as file:
        for _, channel, message in make_reader(file).iter_messages():
            reported = json.loads(message.data)
            if channel.topic == "/wire/from_arm" and "status" in reported:
                gaps = reported.get("gaps_ns", [])
                times = message.log_time - sum(gaps) + np.cumsum([0, *gaps])
                statuses += [(int(time), reported["status"]) for time in times]
            if channel.topic == "/wire/to_arm" and ("command" in reported or "error" in reported):
                commands.append((message.log_time, reported))
    return statuses, commands


def both(folder, name):
    from_csv = pd.read_csv(folder / f"{name}.csv")
    from_csv["time"] = pd.to_datetime(from_csv["time"], format="ISO8601")
    from_parquet = pd.read_parquet(folder / f"{name}.parquet")
    assert list(from_csv.columns) == list(from_parquet.columns), name
    return from_csv, from_parquet


def check_statuses(folder, expected):
    for table in both(folder, "run"):
        assert len(table) == len(expected), len(table)
        times = table["time"].astype("datetime64[ns, UTC]").astype("int64")
        assert list(times) == [time for time, _ in expected]
        for name in [*POSE, *STATE]:
            wanted = np.array([status[name] for _, status in expected], dtype=np.float32)
            assert np.array_equal(table[name].astype(np.float32), wanted), name


def check_commands(folder, expected):
    for table in both(folder, "run.commands"):
        assert len(table) == len(expected), len(table)
        for (_, row), (_, reported) in zip(table.iterrows(), expected):
            if "error" in reported:
                assert row["error"] == reported["error"] and pd.isna(row["command"]), row
                continue
            fields = dict(reported["command"])
            assert row["command"] == fields.pop("type"), row
            assert json.loads(row["fields"]) == fields, row


def check_dataset(folder, statuses):
    """As LeRobot loads a dataset of the format v3.0."""
    info = json.loads((folder / "meta/info.json").read_text())
    assert info["codebase_version"] == "v3.0"
    features = datasets.Features({name: feature(it) for name, it in info["features"].items()})
    data = datasets.Dataset.from_parquet(str(folder / "data/chunk-000/file-000.parquet"), features=features)
    data = data.with_format("numpy")[:]
    episodes = datasets.Dataset.from_parquet(str(folder / "meta/episodes/chunk-000/file-000.parquet"))
    tasks = pd.read_parquet(folder / "meta/tasks.parquet")
    stats = json.loads((folder / "meta/stats.json").read_text())
    assert tasks.loc["Turn."].task_index == 0 and len(tasks) == info["total_tasks"] == 1
    assert len(data["index"]) == info["total_frames"] and len(episodes) == info["total_episodes"]
    assert info["splits"] == {"train": f"0:{len(episodes)}"}
    assert np.array_equal(data["index"], np.arange(info["total_frames"]))
    for name in info["features"]:
        values = data[name].reshape(len(data["index"]), -1).astype(np.float64)
        for stat in ["min", "max", "mean", "std"]:
            assert np.allclose(stats[name][stat], getattr(values, stat)(axis=0), rtol=1e-6, atol=1e-6), f"{name} {stat}"
        assert stats[name]["count"] == [len(values)]
        for share in (1, 10, 50, 90, 99):
            quantile = np.quantile(np.asarray(values, dtype=np.float64), share / 100, axis=0)
            assert np.allclose(stats[name][f"q{share:02}"], quantile, rtol=1e-5, atol=1e-5), f"{name} q{share:02}"
    stretches = without_silence(statuses)
    assert len(stretches) == len(episodes), len(stretches)
    for number, (episode, stretch) in enumerate(zip(episodes, stretches)):
        assert episode["episode_index"] == number and episode["tasks"] == ["Turn."]
        rows = slice(episode["dataset_from_index"], episode["dataset_to_index"])
        check_episode({name: it[rows] for name, it in data.items()}, episode, stretch, info["fps"])
    return len(episodes)


def feature(reported):
    value = datasets.Value(reported["dtype"])
    return value if reported["shape"] == [1] else datasets.Sequence(value, length=reported["shape"][0])


def without_silence(statuses):
    stretches = [[statuses[0]]]
    for before, after in zip(statuses, statuses[1:]):
        if after[0] - before[0] > 1e9:
            stretches.append([])
        stretches[-1].append(after)
    return [it for it in stretches if len(it) > 1]


def check_episode(rows, episode, stretch, fps):
    count = len(rows["index"])
    assert count == episode["length"] == math.floor((stretch[-1][0] - stretch[0][0]) * fps / 1e9 + 1e-6) + 1
    assert np.array_equal(rows["frame_index"], np.arange(count))
    # LeRobot takes 1e-4 s of difference.
    assert np.allclose(rows["timestamp"], np.arange(count) / fps, atol=1e-5)
    assert np.array_equal(rows["action"][:-1], rows["observation.state"][1:])
    times = [(time - stretch[0][0]) / 1e9 for time, _ in stretch]
    for names, found in [(STATE[:4], rows["observation.state"]), (POSE, rows["observation.pose"])]:
        for n, name in enumerate(names):
            wanted = np.interp(np.arange(count) / fps, times, [status[name] for _, status in stretch])
            assert np.allclose(found[:, n], wanted, atol=1e-4), name


main(pathlib.Path(sys.argv[1]))
