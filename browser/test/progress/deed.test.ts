import { expect, test } from 'vitest'
import { deedOf } from '../../src/progress/deed'
import { plain } from '../../src/texts/say'

const choice = (command: string) => ({
  key: 'foresight.do_choose',
  text: `${command}: it is cleared`,
  args: { command, meaning: plain('it is cleared') },
})

test.each([
  ['clear', 'Try again'],
  ['next flow1', 'Leave this action (flow1)'],
  ['skip flow0 N', 'Go on with another action (flow0)'],
  ['skip N', 'Go on with another action'],
  ['pass flow1', 'Let it go on alone (flow1)'],
  ['abort', 'End the run'],
  ['newer', 'newer'],
])('what is typed as %s is the button %s', (command, button) => {
  expect(deedOf(choice(command))).toEqual({ button, meaning: 'it is cleared' })
})

test('what is reset or ended at a console has its button too', () => {
  expect(deedOf({ key: 'foresight.do_reset', text: 'reset' }).button).toBe('Reset')
  expect(deedOf({ key: 'foresight.do_end_frozen', text: 'Ctrl-C' }).button).toBe('End the runtime')
  expect(deedOf({ key: 'foresight.do_end_frozen', text: 'Ctrl-C' }).meaning).not.toContain('Ctrl')
})

test('what no button does is said as it is', () => {
  expect(deedOf(plain('Let the button go.'))).toEqual({ button: '', meaning: 'Let the button go.' })
})
