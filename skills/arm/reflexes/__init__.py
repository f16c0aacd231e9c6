"""The reflexes of arms and hands, a file each."""
