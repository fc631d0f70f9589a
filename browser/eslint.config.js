// What is forbidden in the page's code beyond types; how it looks is Prettier's.
import js from '@eslint/js'
import svelte from 'eslint-plugin-svelte'
import globals from 'globals'
import { defineConfig, globalIgnores } from 'eslint/config'
import ts from 'typescript-eslint'

export default defineConfig([
  globalIgnores(['node_modules/', 'src/api.gen.ts']),
  js.configs.recommended,
  ...ts.configs.strict,
  ...svelte.configs.recommended,
  {
    languageOptions: { globals: { ...globals.browser, ...globals.node } },
    linterOptions: { reportUnusedDisableDirectives: 'error' },
  },
  { files: ['**/*.svelte', '**/*.svelte.ts'], languageOptions: { parserOptions: { parser: ts.parser } } },
  {
    rules: {
      // an index or a key is asserted where the line before has looked; there is nothing else to say where it is not there
      '@typescript-eslint/no-non-null-assertion': 'off',
      // maps of the tree lose keys by patches, which is what `delete` is for
      '@typescript-eslint/no-dynamic-delete': 'off',
      '@typescript-eslint/no-unused-expressions': ['error', { allowShortCircuit: true, allowTernary: true }],
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_', varsIgnorePattern: '^_' }],
      // svelte-check says itself which of its warnings are ignored in vain
      'svelte/no-unused-svelte-ignore': 'off',
      // what nobody draws from stays a plain map or set on purpose
      'svelte/prefer-svelte-reactivity': 'off',
      // values that come at the rate of frames are written past reactivity
      'svelte/no-dom-manipulating': 'off',
      // Prettier writes a blank that counts as {' '}
      'svelte/no-useless-mustaches': 'off',
    },
  },
  {
    files: ['test/**'],
    // stand-ins for classes of the browser need no more than a name
    rules: { '@typescript-eslint/no-extraneous-class': 'off' },
  },
])
