"""Makes a video for a fake camera from the pictures of hands in the npm package `fingerpose` (MIT): video.py ARCHIVE OUT.y4m"""

from __future__ import annotations

import sys
import tarfile

import cv2
import numpy as np

WIDTH, HEIGHT = 640, 480
PICTURES = ("nocurl", "halfcurl", "fullcurl")


def main(archive: str, out: str) -> None:
    with tarfile.open(archive) as package, open(out, "wb") as video:
        video.write(f"YUV4MPEG2 W{WIDTH} H{HEIGHT} F10:1 Ip A1:1 C420mpeg2\n".encode())
        for name in PICTURES:
            file = package.extractfile(f"package/assets/{name}.jpg")
            assert file is not None
            picture = cv2.imdecode(np.frombuffer(file.read(), np.uint8), cv2.IMREAD_COLOR)
            # Upright pictures, with white on both sides.
            scale = HEIGHT / picture.shape[0]
            small = cv2.resize(picture, (round(picture.shape[1] * scale / 2) * 2, HEIGHT))
            wide = np.full((HEIGHT, WIDTH, 3), 200, np.uint8)
            left = (WIDTH - small.shape[1]) // 4 * 2
            wide[:, left : left + small.shape[1]] = small
            frame = cv2.cvtColor(wide, cv2.COLOR_BGR2YUV_I420).tobytes()
            for _ in range(20):
                video.write(b"FRAME\n" + frame)


if __name__ == "__main__":
    main(*sys.argv[1:])
