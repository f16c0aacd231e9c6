"""Opening and closing a gripper."""
