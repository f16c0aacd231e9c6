"""A typed client of the executive: ``executive.client.sync.Client``, ``executive.client.aio.AsyncClient``."""
