// typescript-eslint's strictest set with types. What differs from it stands here with its reason.
import tseslint from 'typescript-eslint';

export default tseslint.config(
  tseslint.configs.strictTypeChecked,
  {
    files: ['src/**/*.ts'],
    languageOptions: { parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname } },
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      // A number has one form as text; `undefined`, objects and booleans stay errors.
      '@typescript-eslint/restrict-template-expressions': ['error', { allowNumber: true }],
      // `() => button.focus()` is shorter than a block; a void value in any other expression stays an error.
      '@typescript-eslint/no-confusing-void-expression': [
        'error',
        { ignoreArrowShorthand: true, ignoreVoidOperator: true },
      ],
    },
  },
  {
    // Numbers of buffers, whose loops keep within them; the report's figures and the desk's screens have none of it.
    files: ['src/view/**/*.ts', 'src/convert/**/*.ts', 'src/live.ts'],
    rules: { '@typescript-eslint/no-non-null-assertion': 'off' },
  },
);
