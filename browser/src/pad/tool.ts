// Where the tool is that is led: the pose that a job or a configuration measures now.
import { desk } from '../link/desk.svelte'
import { canvas } from '../state/canvas.svelte'
import { latest } from '../values/frames'

/** The variable in which it is, as it is watched. */
export function toolVariable(): string {
  const run = desk.tree.run
  return `${run && run.state !== 'over' ? run.doc : canvas.doc}/X_MEZ`
}

/** Its place in m; undefined where nothing measures it. */
export function toolPlace(): readonly [number, number, number] | undefined {
  const rows = [latest(toolVariable())].flat(2).map(Number)
  return rows.length === 16 && rows.every(Number.isFinite) ? [rows[3]!, rows[7]!, rows[11]!] : undefined
}
