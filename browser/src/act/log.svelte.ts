// Lines that the environment said, newest last.
import type { Say } from '../api.gen'

const LONGEST = 2000

export interface Line extends Say {
  id: number
}

let lastId = 0
export const log: { lines: Line[] } = $state({ lines: [] })

export function addLine(say: Say): Line {
  const line: Line = { ...say, id: ++lastId, at_s: say.at_s || Date.now() / 1000 }
  log.lines.push(line)
  if (log.lines.length > LONGEST) log.lines.splice(0, log.lines.length - LONGEST)
  return line
}

export function clearLog(): void {
  log.lines = []
}
