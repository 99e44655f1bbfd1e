"""Uses a dataset of `dobot log --export lerobot` as a training run does, with LeRobot's own code.

python tests/recordings/load_lerobot.py DATASET

It loads the dataset, reads chunks of later actions, and normalizes states and actions by their quantiles and back.
"""

import json
import pathlib
import sys

import torch
from lerobot.configs.types import FeatureType, NormalizationMode
from lerobot.datasets.lerobot_dataset import LeRobotDataset
from lerobot.datasets.utils import dataset_to_policy_features
from lerobot.processor import NormalizerProcessorStep, UnnormalizerProcessorStep
from lerobot.processor.converters import batch_to_transition, transition_to_batch

CHUNK = 4
KEYS = ["observation.state", "observation.pose", "action"]


def main(folder):
    info = json.loads((folder / "meta/info.json").read_text())
    later = [step / info["fps"] for step in range(CHUNK)]
    dataset = LeRobotDataset("me/dataset", root=folder, delta_timestamps={"action": later})
    assert len(dataset) == info["total_frames"] and dataset.num_episodes == info["total_episodes"]
    assert dataset[0]["task"] == next(iter(dataset.meta.tasks.index))
    for index in range(len(dataset)):
        check_chunk(dataset, index)
    batch = next(iter(torch.utils.data.DataLoader(dataset, batch_size=len(dataset))))
    for mode in (NormalizationMode.QUANTILES, NormalizationMode.QUANTILE10):
        check_normalized(dataset, batch, mode)
    print(f"{len(dataset)} frames in {dataset.num_episodes} episodes, loaded and normalized by quantiles")


def check_chunk(dataset, index):
    """Actions of later frames are those of the same episode; after its end the last one repeats."""
    frame = dataset[index]
    end = dataset.meta.episodes[int(frame["episode_index"])]["dataset_to_index"]
    for step in range(CHUNK):
        wanted = dataset.hf_dataset[min(index + step, end - 1)]["action"]
        assert torch.equal(frame["action"][step], wanted), (index, step)
        assert bool(frame["action_is_pad"][step]) == (index + step >= end), (index, step)


def check_normalized(dataset, batch, mode):
    features = dataset_to_policy_features(dataset.meta.features)
    modes = {FeatureType.STATE: mode, FeatureType.ACTION: mode}
    normalizer = NormalizerProcessorStep(features=features, norm_map=modes, stats=dataset.meta.stats)
    unnormalizer = UnnormalizerProcessorStep(features=features, norm_map=modes, stats=dataset.meta.stats)
    normalized = normalizer(batch_to_transition(batch))
    restored = transition_to_batch(unnormalizer(normalized))
    normalized = transition_to_batch(normalized)
    low, high = ("q01", "q99") if mode == NormalizationMode.QUANTILES else ("q10", "q90")
    for key in KEYS:
        assert torch.allclose(restored[key], batch[key], rtol=1e-4, atol=1e-3), key
        bounds = [torch.as_tensor(dataset.meta.stats[key][name]) for name in (low, high)]
        moving = bounds[1] > bounds[0]
        inside = (batch[key] >= bounds[0]) & (batch[key] <= bounds[1])
        values = normalized[key][..., moving]
        assert moving.any(), key
        assert torch.equal(inside[..., moving], (values >= -1 - 1e-4) & (values <= 1 + 1e-4)), key


main(pathlib.Path(sys.argv[1]))
