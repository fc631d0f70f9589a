// What keys mean in the workspace (table B.4).
import { beforeEach, describe, expect, test, vi } from 'vitest'

vi.hoisted(() => {
  vi.stubGlobal('navigator', { language: 'en' })
  vi.stubGlobal('Element', class {})
  vi.stubGlobal('HTMLElement', class {})
})
vi.mock('../../src/link/link', () => ({ send: () => Promise.resolve(null), hear: () => () => undefined }))

const { workspace } = await import('../../src/state/workspace.svelte')
const { workspaceState } = await import('../../src/workspace/workspaceState.svelte')
const { keyDown } = await import('../../src/workspace/keys')
const { deselect, select } = await import('../../src/workspace/acts')
const { openProgram } = await import('./openProgram')

const press = (key: string, more: Partial<KeyboardEvent> = {}): boolean => keyDown({ key, ...more } as KeyboardEvent)

beforeEach(openProgram)

describe('keys', () => {
  test('move the cursor; what is selected alone goes along', () => {
    // R-X11
    press('ArrowRight')
    press('ArrowRight')
    expect(workspace.place).toEqual({ flow: '0', after: 2 })
    expect(workspace.steps.size).toBe(0)
    press(' ')
    press('ArrowRight')
    expect([...workspace.steps]).toEqual([3])
    press('Home')
    expect(workspace.place.after).toBe(0)
    press('End')
    expect(workspace.place.after).toBe(4)
  })

  test('with Shift select more', () => {
    // R-X11
    press('ArrowRight')
    press('ArrowRight', { shiftKey: true })
    press('ArrowRight', { shiftKey: true })
    expect([...workspace.steps]).toEqual([1, 2, 3])
  })

  test('begin a search by a letter, where nothing is selected', () => {
    // R-X11
    press('o')
    expect(workspaceState.opened).toEqual({ kind: 'quick', words: 'o' })
  })

  test('of table B.4 stay what they are there', () => {
    // R-G04
    select(2)
    expect(press('c')).toBe(false)
    deselect()
    expect(press('v')).toBe(false)
    expect(workspaceState.opened.kind).toBe('')
  })
})
