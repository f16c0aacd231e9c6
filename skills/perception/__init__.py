"""See: tags, clutter and where the camera is. The only home of OpenCV among the skills.

Skills: look, track, turn_head, snapshot, process; head_reflexes.
Occupied space: mapper, occupancy.
A run: session, eye, camera, camera_frames, head, head_view, ramp, blind.
Where to look: aim, cover, gaze.
Reading a picture: jobs, detectors, tags, corners, tag_pose, depth, clutter, arms, open_view, merge, rigid.
"""
