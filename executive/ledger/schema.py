"""The tables of the ledger's file, and how a file of an older version becomes one of this."""

from __future__ import annotations

from typing import Final

MIGRATIONS: Final[tuple[tuple[str, ...], ...]] = (
    (
        """CREATE TABLE tasks (
            number INTEGER PRIMARY KEY,      -- order of arrival
            task TEXT NOT NULL UNIQUE,
            kind TEXT NOT NULL,
            state TEXT NOT NULL,
            open INTEGER NOT NULL,           -- 1 until it has ended
            client_id TEXT,                  -- the client's own id of its request, if it gave one
            accepted_at REAL NOT NULL,       -- UTC seconds
            ended_at REAL,                   -- UTC seconds
            on_restart TEXT,
            test_run INTEGER NOT NULL,
            status TEXT NOT NULL             -- TaskStatus as JSON, with the request's document
        ) STRICT""",
        "CREATE UNIQUE INDEX by_client ON tasks (client_id) WHERE client_id IS NOT NULL",
        "CREATE INDEX those_open ON tasks (number) WHERE open = 1",
        "CREATE INDEX those_ended ON tasks (ended_at) WHERE open = 0",
        """CREATE TABLE transitions (
            task TEXT NOT NULL,
            state TEXT NOT NULL,
            at REAL NOT NULL                 -- UTC seconds
        ) STRICT""",
        "CREATE INDEX of_task ON transitions (task)",
        """CREATE TABLE goals (
            goal_id TEXT PRIMARY KEY,        -- task/node/attempt
            task TEXT NOT NULL,
            node TEXT NOT NULL,
            attempt INTEGER NOT NULL,
            action TEXT NOT NULL,
            how TEXT                         -- how it ended; NULL while that is not known
        ) STRICT""",
        "CREATE INDEX goals_of_task ON goals (task)",
        "CREATE INDEX goals_open ON goals (task) WHERE how IS NULL",
        """CREATE TABLE past (
            place INTEGER PRIMARY KEY,       -- order of writing
            kind TEXT NOT NULL,
            phase TEXT NOT NULL,
            remaining REAL NOT NULL          -- robot seconds from the phase's beginning to the task's end
        ) STRICT""",
        "CREATE INDEX past_of_kind ON past (kind, phase)",
    ),
    (
        # Of a task that is forgotten the row stays when a client named it: so that it does not run again.
        "ALTER TABLE tasks ADD COLUMN forgotten INTEGER NOT NULL DEFAULT 0",
        "DROP INDEX those_ended",
        "CREATE INDEX those_ended ON tasks (ended_at) WHERE open = 0 AND forgotten = 0",
        "CREATE INDEX those_forgotten ON tasks (number) WHERE forgotten = 1",
        """CREATE TABLE clock (
            one INTEGER PRIMARY KEY CHECK (one = 1),
            utc REAL NOT NULL,               -- seconds
            host TEXT NOT NULL,              -- names the start of the host
            monotonic REAL NOT NULL,         -- seconds of that start
            doubt REAL NOT NULL              -- seconds at work for which utc tells no age
        ) STRICT""",
        """INSERT INTO clock (one, utc, host, monotonic, doubt)
            SELECT 1, max(at), '', 0.0, 0.0 FROM transitions HAVING count(*) > 0""",
    ),
    ("ALTER TABLE tasks ADD COLUMN memory TEXT NOT NULL DEFAULT '{}'",),  # TaskMemory as JSON
    (
        # Two clients may both call a request "1".
        "ALTER TABLE tasks ADD COLUMN asked_by TEXT NOT NULL DEFAULT ''",
        "UPDATE tasks SET asked_by = coalesce(json_extract(status, '$.request.by'), '')",
        "DROP INDEX by_client",
        "CREATE UNIQUE INDEX by_client ON tasks (asked_by, client_id) WHERE client_id IS NOT NULL",
    ),
    (
        """CREATE TABLE robot (
            one INTEGER PRIMARY KEY CHECK (one = 1),
            name TEXT NOT NULL               -- site/robot whose tasks these are
        ) STRICT""",
    ),
)
"""By version: what leads from the one before to it. Add to the end; never change what was released."""

VERSION: Final = len(MIGRATIONS)
"""The version of a file of this program (SQLite's ``user_version``)."""
