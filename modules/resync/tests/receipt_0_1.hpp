// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A receipt as wm3d 0.1.0 wrote it.
#pragma once

constexpr const char* receipt_of_0_1 = R"({
  "schema": "wm3d.receipt/1",
  "tool": "wm3d 0.1.0",
  "key": {
    "fingerprint": "3e5279a6f16b20e8",
    "commitment": "cccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccccc"
  },
  "files": {
    "original": {
      "sha256": "0682c5f2076f099c34cfdd15a9e063849ed437a49677e6fcc5b4198c76575be5",
      "bytes": 8
    },
    "marked": {
      "sha256": "d9b2fe68b6c253e250b14667fe79d988b4d2ac568f7fd62357330b906c30a49d",
      "bytes": 6
    }
  },
  "mark": {
    "base_vertices": 1500,
    "level": 5,
    "gamma": 0.07,
    "rmax": 0.1,
    "rms_percent": 0.05
  },
  "frame": {
    "centroid": [
      0.026952023830674125,
      -0.007799184481786306,
      0.007189203004783303
    ],
    "axes": [
      [
        0.9755192683267153,
        -0.21968950919528094,
        0.009933613282516613
      ],
      [
        -0.2125788357616141,
        -0.9535877003199835,
        -0.21326213068588137
      ],
      [
        0.0563240242662642,
        0.20592964174198386,
        -0.9769445157952786
      ]
    ],
    "scale": 1.0095646680450518
  },
  "template": {
    "min": [
      -0.9902069314883322,
      -0.9231183501065396,
      -0.5638189405523911
    ],
    "max": [
      1.0417580266868125,
      0.9474038552451653,
      0.735791279618475
    ],
    "data": "Rq53gv//D/t+XZLuOQAAGNyJamMAADQo/5DDkDbAEJMi0KK5i26Tixjz5gJ85UPWj7ji7B16AACerHMLwiiZQjH//yxfy3P2MZCJ/49mHnsBZtwe4ms8OmXM//9qrAgrTzSr//ZCUoEEJ96M"
  },
  "digest": "fe3856b9ea319ad6d93194e17585ffe4454b3779da4468b3ab278c5187d4f63f"
}
)";
