import { beforeAll, describe, expect, it } from 'vitest'
import { look } from '../../src/state/look.svelte'
import { choicesText, homeOf, choicesIn } from '../../src/application/redirectChoices'
import { fetchTranslation } from '../../src/texts/translations.svelte'

beforeAll(() => fetchTranslation('es'))

const app = {
  name: 'play',
  order: 1,
  redirects: [
    { old: 'puma', new: 'scara', homes: ['flow0', 'flow1'] },
    { old: 'gripper', new: 'gripper_right', flow: 'flow1', homes: ['flow1'] },
    { old: 'pd', new: 'pid' },
  ],
}

describe('who stands for whom', () => {
  it('is marked in the flows that use it, and in what is nested in their branches', () => {
    expect(homeOf('1/17/0')).toBe('flow1')
    expect(choicesIn(app, '0').map((one) => one.old)).toEqual(['puma'])
    expect(choicesIn(app, '1/17/0').map((one) => one.old)).toEqual(['puma', 'gripper'])
    expect(choicesIn(undefined, '0')).toEqual([])
  })

  it('is said with its flow where it holds in one only', () => {
    look.language = 'en'
    expect(choicesText(app.redirects)).toBe('puma → scara, gripper → gripper_right in flow 1, pd → pid')
    look.language = 'es'
    expect(choicesText(app.redirects)).toBe('puma → scara, gripper → gripper_right en flujo 1, pd → pid')
  })
})
