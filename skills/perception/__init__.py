"""See: tags, clutter and where the camera is. The only home of OpenCV among the skills."""
