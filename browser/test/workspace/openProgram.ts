// An application of three actions, one of them with a target, open in the workspace.
import { vi } from 'vitest'
import type { StepView } from '../../src/api.gen'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { closeDialog } from '../../src/state/dialogs.svelte'
import { look } from '../../src/state/look.svelte'
import { pickSteps, workspace } from '../../src/state/workspace.svelte'
import { workspaceState } from '../../src/workspace/workspaceState.svelte'

const job = (name: string, right: string): StepView => ({
  name,
  role: 'job',
  type: 'job',
  left: '0',
  right,
  description: name,
})
const target: StepView = { name: 'home', role: 'target', type: 'object', left: '1', right: '0', is_joined: true }
const STEPS: Record<string, StepView> = { 1: job('open', '0'), 2: job('turn', '1'), 3: target, 4: job('close', '0') }

/** Nothing is selected, and the cursor stands at the start. */
export function openProgram(): void {
  vi.stubGlobal('document', { elementFromPoint: () => null, activeElement: null })
  desk.tree = fullTree({
    applications: {
      a1: { name: 'one', order: 0, steps: STEPS, flows: { 0: { steps: [1, 2, 3, 4], start: '0', end: '0' } } },
    },
    onikons: {
      open: {
        type: 'job',
        role: 'job',
        order: 0,
        dictionary: '',
        left: '0',
        right: '0',
        picture: '',
        source: '/b/conf/open.conf',
      },
      turn: {
        type: 'job',
        role: 'job',
        order: 0,
        dictionary: '',
        left: '0',
        right: '1',
        picture: '',
        source: '/b/conf/turn.conf',
      },
    },
  })
  look.level = 'applications'
  Object.assign(workspace, { app: 'a1', onikon: '', place: { flow: '0', after: 0 } })
  closeDialog()
  pickSteps()
  Object.assign(workspaceState, { width: 1000, height: 600, top: 0, hasKeys: true })
  workspaceState.close()
}
