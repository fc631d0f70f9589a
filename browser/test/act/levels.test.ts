// R-G05: the two levels are one tool; going from one to the other loses nothing.
import { beforeEach, describe, expect, test } from 'vitest'
import { desk, fullTree } from '../../src/link/desk.svelte'
import { canvas, pick } from '../../src/state/canvas.svelte'
import { look } from '../../src/state/look.svelte'
import { pickSteps, workspace } from '../../src/state/workspace.svelte'
import { hideRefusal, refused } from '../../src/act/refused.svelte'
import { begin, goTo, inOrder, origin, settle, show, shownId, shownOne, step } from '../../src/act/documents.svelte'
import { jobOf } from '../../src/files/jobs'

const named = (...names: string[]): Record<string, { name: string; order: number }> =>
  Object.fromEntries(names.map((name, order) => [name, { name, order }]))

beforeEach(() => {
  desk.tree = fullTree({ documents: named('c1', 'c2'), applications: named('a1', 'a2') })
  Object.assign(look, { level: 'tasks', isUpperOnly: false })
  Object.assign(workspace, { app: 'a1', place: { flow: '0', after: 0 } })
  canvas.doc = 'c1'
  Object.assign(origin, { doc: '', app: '' })
  pick()
  pickSteps()
  hideRefusal()
})

describe('R-G05: the levels', () => {
  test('what is shown and picked at each stays when one goes to the other', () => {
    pick('pd')
    goTo('applications')
    pickSteps(3, 4)
    expect([shownId(), shownOne()?.name]).toEqual(['a1', 'a1'])
    goTo('tasks')
    expect([shownId(), [...canvas.picked], [...workspace.steps]]).toEqual(['c1', ['pd'], [3, 4]])
  })

  test('a document comes to the front at its own level', () => {
    show('a2')
    expect([look.level, workspace.app, canvas.doc]).toEqual(['applications', 'a2', 'c1'])
    show('c2')
    expect([look.level, workspace.app, canvas.doc]).toEqual(['tasks', 'a2', 'c2'])
  })

  test('the insertion cursor is where it was, in each application', () => {
    workspace.place = { flow: '0', after: 7 }
    show('a2')
    expect(workspace.place).toEqual({ flow: '0', after: 0 })
    show('a1')
    expect(workspace.place).toEqual({ flow: '0', after: 7 })
  })

  test('tabs are walked within a level', () => {
    look.level = 'applications'
    step(1)
    step(1)
    expect([workspace.app, inOrder().map(([id]) => id)]).toEqual(['a1', ['a1', 'a2']])
  })

  test('what vanished gives way at its own level, and the level stays', () => {
    const known = settle(new Set())
    desk.tree = fullTree({ documents: named('c1'), applications: named('a2', 'a3') })
    settle(known)
    expect([look.level, canvas.doc, workspace.app]).toEqual(['tasks', 'c1', 'a3'])
  })

  test('a session that has an application and nothing else begins with it', () => {
    begin()
    expect(look.level).toBe('applications')
    look.level = 'tasks'
    desk.tree = fullTree({ documents: { c1: { name: 'c1', order: 0, path: '/c1.conf' } }, applications: named('a1') })
    begin()
    expect(look.level).toBe('tasks')
  })

  test('one finds back from a configuration to the application that one came from', () => {
    show('a2')
    show('c2')
    expect(origin).toEqual({ doc: 'c2', app: 'a2' })
  })

  test('who needs only the upper one is told why the other does not come, and how it would', () => {
    look.isUpperOnly = true
    goTo('applications')
    show('c2')
    expect(look.level).toBe('applications')
    expect(refused.why?.remedies[0]?.act).toEqual({ t: 'Prefer', values: { shows_lower: true } })
  })
})

test('R-G05: a configuration says which job is made of it', () => {
  const onikon = {
    type: 'Joint job',
    order: 0,
    dictionary: '',
    left: '0',
    right: '1',
    picture: '',
    description: 'move the joints',
  }
  const onikons = { jmoveC: { ...onikon, role: 'job' as const, source: '/b/conf/jmoveC.conf' } }
  expect([jobOf('/b/conf/jmoveC.conf', onikons), jobOf('/b/conf/other.conf', onikons), jobOf('', onikons)]).toEqual([
    'move the joints',
    '',
    '',
  ])
})
