// What is asked for once and kept: who the robot is, the place, the kinds of task.
import { useEffect, useState } from "preact/hooks";
import { get } from "./api";
import { useLive } from "./state";
import type { RobotDescription, Site, TaskKinds } from "./types";

export type Kinds = TaskKinds & { unable: Record<string, string> };
export type Loaded<T> = { value: T | null; error: string };

// Asks again when the boot of the hardware or the executive is another one, and while there is no answer.
export function useLoaded<T>(path: string, ...about: unknown[]): Loaded<T> {
  const [loaded, set] = useState<Loaded<T>>({ value: null, error: "" });
  const there = useLive((live) => live.executive);
  useEffect(() => {
    let over = false;
    let timer = 0;
    const load = async () => {
      try {
        const value = await get<T>(path);
        if (!over) set({ value, error: "" });
      } catch (error) {
        if (over) return;
        set((known) => ({ value: known.value, error: error instanceof Error ? error.message : String(error) }));
        timer = setTimeout(load, 2000);
      }
    };
    void load();
    return () => {
      over = true;
      clearTimeout(timer);
    };
  }, [path, there, ...about]);
  return loaded;
}

export function useRobot() {
  const boot = useLive((live) => live.now?.boot ?? "");
  return useLoaded<RobotDescription>("/api/robot", boot);
}
export const useSite = () => useLoaded<Site>("/api/site");
export const useKinds = () => useLoaded<Kinds>("/api/kinds");
