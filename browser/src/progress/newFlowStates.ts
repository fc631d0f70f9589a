// What of a run is worth saying to those who do not see it: flows that come to rest, and those that meet.
import type { FlowRunView, RunView } from '../api.gen'

const WORTH = ['paused', 'waiting', 'joining', 'ended']

/** The flows whose state has become one that is worth a word. */
export function newFlowStates(before: RunView | undefined, now: RunView): FlowRunView[] {
  const isSame = before?.number === now.number
  return Object.entries(now.flows ?? {}).flatMap(([name, flow]) => {
    const was = isSame ? before?.flows?.[name]?.state : undefined
    return !flow.is_nested && flow.state !== undefined && flow.state !== was && WORTH.includes(flow.state) ? [flow] : []
  })
}
